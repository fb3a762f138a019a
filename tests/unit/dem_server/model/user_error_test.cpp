// Every scene that cannot be computed: the error names the field and says what to do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "dem_server/model/calibration.hpp"
#include "protocol/errors.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/dem_server/cantilever_scene.hpp"

namespace adit::dem::user_error_test {
namespace {

using Case = adit::test::Refusal<std::function<void(scene::Scene&)>>;
class UserErrors : public testing::TestWithParam<Case> {};

TEST_P(UserErrors, NamesTheFieldAndTheRemedy) {
  auto scene = test::cantilever_scene();
  GetParam().input(scene);
  adit::test::expect_refusal([&] { test::InProcessRun run(scene); }, GetParam().path, GetParam().message);
}

scene::HexagonalPacking& packing(scene::Scene& s) {
  return *s.mutable_particles()->mutable_packing();
}
scene::Bonds& bonds(scene::Scene& s) {
  return *s.mutable_particles()->mutable_bonds();
}
// Of all particles.
scene::ParticleMotion& add_motion(scene::Scene& s) {
  auto& motion = *s.mutable_particles()->add_motions();
  motion.mutable_where();
  motion.mutable_velocity();
  return motion;
}

INSTANTIATE_TEST_SUITE_P(
    All, UserErrors,
    testing::Values(
        Case{"NoParticles", "particles", "needs a scene with particles",
             [](auto& s) { s.clear_particles(); }},
        Case{"NegativeRadius", "particles.packing.radius", "above 0",
             [](auto& s) { packing(s).set_radius(-1); }},
        Case{"EmptyBox", "particles.packing.x_max", "is 0 m, expected a length above `x_min` = 0 m",
             [](auto& s) { packing(s).set_x_max(0); }},
        Case{"FlatBox", "particles.packing.y_max", "is -1 m, expected a length above `y_min` = 0 m",
             [](auto& s) { packing(s).set_y_max(-1); }},
        Case{"TooSmall", "particles.packing", "holds 0 particle(s)",
             [](auto& s) { packing(s).set_radius(6); }},
        Case{"HistoryOfStress", "particles.histories[0].radius",
             "is missing; stress_xx of particles is a mean over a circle",
             [](auto& s) { s.mutable_particles()->mutable_histories(0)->set_quantity(scene::STRESS_XX); }},
        Case{"HistoryOfStrain", "particles.histories[0].quantity",
             "is strain_xx, which particles do not have; choose a motion",
             [](auto& s) { s.mutable_particles()->mutable_histories(0)->set_quantity(scene::STRAIN_XX); }},
        Case{"StripCut", "particles.packing.bends_as_solid", "`within` cuts the packing",
             [](auto& s) {
               packing(s).set_bends_as_solid(true);
               s.mutable_particles()->mutable_within()->set_x_max(5);
             }},
        Case{"StripOfGroups", "particles.packing.bends_as_solid", "`groups` give bonds of several laws",
             [](auto& s) {
               packing(s).set_bends_as_solid(true);
               auto& group = *s.mutable_particles()->add_groups();
               group.set_name("end");
               group.mutable_where()->set_x_max(5);
             }},
        Case{"StripUnderStress", "particles.packing.bends_as_solid", "starts under an initial stress",
             [](auto& s) {
               packing(s).set_bends_as_solid(true);
               s.mutable_initial_stress()->set_xx(-1e6);
             }},
        Case{"StripOfTwoRows", "particles.packing.bends_as_solid", "the packing has 2 row(s)",
             [](auto& s) {
               packing(s).set_bends_as_solid(true);
               packing(s).set_y_max(2 * std::numbers::sqrt3 * packing(s).radius());
             }},
        Case{"StripOfStiffShear", "particles.packing.bends_as_solid", "less than 3 times",
             [](auto& s) {
               packing(s).set_bends_as_solid(true);
               packing(s).set_y_max(3 * std::numbers::sqrt3 * packing(s).radius());
               bonds(s).set_normal_stiffness(1e9);
               bonds(s).set_shear_stiffness(3e9);
             }},
        Case{"StripWithoutBonds", "particles.packing.bends_as_solid", "no bonds join the particles",
             [](auto& s) {
               packing(s).set_bends_as_solid(true);
               s.mutable_particles()->clear_bonds();
               s.mutable_particles()->mutable_contacts();
             }},
        Case{"NoStrengthOfMaterial", "particles.bonds.strength_of_material", "material has no mohr_coulomb",
             [](auto& s) { bonds(s).set_strength_of_material(true); }},
        Case{"NoTension", "material.mohr_coulomb.tension", "is 0",
             [](auto& s) {
               bonds(s).set_strength_of_material(true);
               s.mutable_material()->mutable_mohr_coulomb()->set_cohesion(1e6);
               s.mutable_material()->mutable_mohr_coulomb()->set_tension(0);
             }},
        Case{"StrengthsTwice", "particles.bonds.shear_strength", "is given beside strength_of_material",
             [](auto& s) {
               s.mutable_material()->mutable_mohr_coulomb()->set_cohesion(1e6);
               bonds(s).set_strength_of_material(true);
               bonds(s).set_shear_strength(1e6);
             }},
        Case{"StrengthsOfCementTwice", "particles.bonds.parallel.cohesion",
             "is given beside strength_of_material",
             [](auto& s) {
               s.mutable_material()->mutable_mohr_coulomb()->set_cohesion(1e6);
               bonds(s).set_strength_of_material(true);
               bonds(s).mutable_parallel()->set_normal_stiffness(1e12);
               bonds(s).mutable_parallel()->set_shear_stiffness(1e12);
               bonds(s).mutable_parallel()->set_cohesion(1e6);
             }},
        Case{"StrengthOfSquareLattice", "particles.bonds.strength_of_material", "hexagonal packing only",
             [](auto& s) {
               s.mutable_material()->mutable_mohr_coulomb()->set_cohesion(1e6);
               s.mutable_material()->mutable_mohr_coulomb()->set_friction_angle(0.5);
               bonds(s).set_strength_of_material(true);
               auto& square = *s.mutable_particles()->mutable_square_packing();
               square.set_x_min(0);
               square.set_x_max(10);
               square.set_y_min(0);
               square.set_y_max(1);
               square.set_radius(packing(s).radius());
               s.mutable_particles()->clear_packing();
             }},
        Case{"OneParticle", "particles.packing", "holds 1 particle(s)",
             [](auto& s) {
               packing(s).set_x_max(1);
               packing(s).set_radius(0.5);
             }},
        Case{"TooMany", "particles.packing.radius", "enlarge it",
             [](auto& s) { packing(s).set_radius(1e-7); }},
        Case{"PlaneStressLimit", "material.poisson_ratio", "0.3333 in plane stress",
             [](auto& s) { s.mutable_material()->set_poisson_ratio(0.34); }},
        Case{"PlaneStrainLimit", "material.poisson_ratio", "0.25 in plane strain",
             [](auto& s) {
               s.set_plane(scene::PLANE_STRAIN);
               s.mutable_material()->set_poisson_ratio(0.26);
             }},
        Case{"AuxeticMaterial", "material.poisson_ratio", "normal_stiffness",
             [](auto& s) { s.mutable_material()->set_poisson_ratio(-0.1); }},
        Case{"NoDensity", "material.density", "above 0",
             [](auto& s) { s.mutable_material()->set_density(0); }},
        Case{"NoModulus", "material.young_modulus", "is missing; write for example",
             [](auto& s) { s.mutable_material()->clear_young_modulus(); }},
        Case{"NoMaterial", "material", "is missing; give it, or particles.material",
             [](auto& s) { s.clear_material(); }},
        Case{"OwnModulus", "particles.material.young_modulus", "above 0",
             [](auto& s) {
               *s.mutable_particles()->mutable_material() = s.material();
               s.mutable_particles()->mutable_material()->set_young_modulus(-1);
             }},
        Case{"OwnLaw", "particles.material", "which bonds do not compute",
             [](auto& s) {
               *s.mutable_particles()->mutable_material() = s.material();
               s.mutable_particles()->mutable_material()->mutable_mohr_coulomb()->set_cohesion(1e6);
             }},
        Case{"NegativeNormal", "particles.bonds.normal_stiffness", "above 0",
             [](auto& s) { bonds(s).set_normal_stiffness(-1); }},
        Case{"NegativeShear", "particles.bonds.shear_stiffness",
             "is -1 N/m, expected a stiffness of at least 0 N/m",
             [](auto& s) { bonds(s).set_shear_stiffness(-1); }},
        Case{"NoTensileStrength", "particles.bonds.tensile_strength", "above 0",
             [](auto& s) { bonds(s).set_tensile_strength(0); }},
        Case{"NoShearStrength", "particles.bonds.shear_strength", "above 0",
             [](auto& s) { bonds(s).set_shear_strength(-5); }},
        Case{"LoadMisses", "particles.loads[0].where", "selects no particles",
             [](auto& s) { s.mutable_particles()->mutable_loads(0)->mutable_where()->set_x_max(0.01); }},
        Case{"LoadTable", "particles.loads[0].time.table.value",
             "has 1 elements, expected 2, as many as `time`",
             [](auto& s) {
               auto& table = *s.mutable_particles()->mutable_loads(0)->mutable_time()->mutable_table();
               table.add_time(1);
               table.add_time(2);
               table.add_value(1);
             }},
        Case{"BodyLoadMisses", "particles.body_loads[1].where", "selects no particles",
             [](auto& s) {
               for (int i = 0; i < 2; ++i) s.mutable_particles()->add_body_loads()->mutable_acceleration();
               s.mutable_particles()->mutable_body_loads(1)->mutable_where()->set_x_min(11);
             }},
        Case{"FoundationMisses", "particles.foundations[0].where", "selects no particles",
             [](auto& s) {
               auto& foundation = *s.mutable_particles()->add_foundations();
               foundation.mutable_y()->set_stiffness(1);
               foundation.mutable_where()->set_x_min(11);
             }},
        Case{"FoundationWithoutSprings", "particles.foundations[0]", "springs in no direction",
             [](auto& s) { s.mutable_particles()->add_foundations(); }},
        Case{"MotionMisses", "particles.motions[0].where", "selects no particles",
             [](auto& s) { s.mutable_particles()->mutable_motions(0)->mutable_where()->set_x_min(11); }},
        Case{"MotionOfNothing", "particles.motions[1]", "prescribes nothing", [](auto& s) { add_motion(s); }},
        Case{"MotionsOverlap", "particles.motions[1].where", "earlier motion",
             [](auto& s) { add_motion(s).mutable_velocity()->set_y(1); }},
        Case{"SpinsOverlap", "particles.motions[1].where", "spin",
             [](auto& s) { add_motion(s).set_spin(1); }}),
    adit::test::kRefusalName);

// Stiffnesses given by the user need no calibration, so any Poisson ratio will do.
TEST(UserStiffnesses, ReplaceTheCalibration) {
  auto scene = test::cantilever_scene();
  scene.mutable_material()->set_poisson_ratio(0.45);
  bonds(scene).set_normal_stiffness(2e10);
  bonds(scene).set_shear_stiffness(0);
  const double mass = cell_mass(2500, test::kCantileverRadius);
  EXPECT_NEAR(test::InProcessRun(scene).model.critical_dt(), 2 / std::sqrt(12 * 2e10 / mass),
              0.3 * std::sqrt(mass / 2e10));
}

// An overlap that leaves no particles is the user's error at the overlap.
TEST(UserErrors, OverlapLeavesNoParticles) {
  const auto scene = test::cantilever_scene();
  wire::Weights weights;
  weights.set_floor(1e-3);
  weights.mutable_weights()->Resize(698 + 1921, 0.0);
  adit::test::expect_refusal([&] { test::InProcessRun run(scene, weights); }, "interface.overlap",
                             "let the packing reach into the overlap");
}

// The particles' own material is taken instead of the scene's: twice the stiffness, a critical step shorter
// by the root of 2.
TEST(UserErrors, OwnMaterialReplacesTheScenes) {
  auto scene = test::cantilever_scene();
  const double of_scene = test::InProcessRun(scene).model.critical_dt();
  auto& own = *scene.mutable_particles()->mutable_material();
  own = scene.material();
  own.set_young_modulus(2 * own.young_modulus());
  scene.clear_material();
  EXPECT_NEAR(test::InProcessRun(scene).model.critical_dt() * std::sqrt(2.0), of_scene, 1e-14 * of_scene);
}

// Loads must find particles among those that exist under the weights.
TEST(UserErrors, LoadOnVanishedParticles) {
  const auto scene = test::cantilever_scene();
  const auto model = test::InProcessRun(scene).model;
  wire::Weights weights;
  weights.set_floor(1e-3);
  for (int k = 0; k < model.sample_points_size(); k += 2)
    weights.add_weights(std::clamp((model.sample_points(k) - 4) / 2, 0.0, 1.0));
  adit::test::expect_refusal([&] { test::InProcessRun run(scene, weights); }, "particles.loads[0].where", "");
}

}  // namespace
}  // namespace adit::dem::user_error_test

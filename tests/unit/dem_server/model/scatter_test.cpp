// Bonds whose stiffness and strength differ from place to place: each has the factors of its place, and
// breaks by them.
#include "dem_server/model/reading/scatter.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "dem_server/engines/general/facets/facets.hpp"
#include "dem_server/engines/general/renumber.hpp"
#include "dem_server/model/bond_springs.hpp"
#include "dem_server/model/reading/read_model.hpp"
#include "dem_server/model/weigh.hpp"
#include "dem_server/packing/meeting_place.hpp"
#include "dem_server/participant/choose_engine.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/dem_server/in_process_run.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::scatter_test {
namespace {

void add_field(scene::Scene& scene, scene::Scatter::Property of, const std::string& rows) {
  auto& scatter = *scene.mutable_particles()->add_scatter();
  scatter.set_of(of);
  scatter.set_path("field.csv");
  scatter.set_content("x_m,y_m,factor\n" + rows);
}

// Stiffness 1 + x / 2, strength 3 - y.
void add_slopes(scene::Scene& scene) {
  add_field(scene, scene::Scatter::STIFFNESS, "0,0,1\n4,0,3\n");
  add_field(scene, scene::Scatter::STRENGTH, "0,0,3\n0,2,1\n");
}
double stiffness_at(double x) {
  return 1 + x / 2;
}
double strength_at(double y) {
  return 3 - y;
}

void set_contacts(scene::Scene& scene) {
  scene.mutable_particles()->mutable_contacts()->set_normal_stiffness(1e9);
  scene.mutable_particles()->mutable_contacts()->set_shear_stiffness(5e8);
}

// `material`: by which the stiffness and the strength of the material are multiplied.
scene::Scene lattice(double material = 1) {
  auto scene = test::empty_scene();
  scene.mutable_material()->set_young_modulus(material * 10e9);
  auto& packing = *scene.mutable_particles()->mutable_packing();
  test::set_box(packing, 4, 2);
  packing.set_radius(0.2);
  set_contacts(scene);
  scene.mutable_particles()->mutable_bonds()->set_tensile_strength(material * 4e5);
  scene.mutable_particles()->mutable_bonds()->set_shear_strength(material * 3e5);
  scene.mutable_particles()->set_engine(scene::Particles::GENERAL);
  return scene;
}

scene::Scene cemented(double material = 1) {
  auto scene = test::empty_scene();
  auto& packing = *scene.mutable_particles()->mutable_square_packing();
  test::set_box(packing, 4, 2);
  packing.set_radius(0.2);
  set_contacts(scene);
  auto& cement = *scene.mutable_particles()->mutable_bonds()->mutable_parallel();
  cement.set_normal_stiffness(material * 2e11);
  cement.set_shear_stiffness(material * 1e11);
  cement.set_tensile_strength(material * 1e6);
  cement.set_cohesion(material * 2e6);
  return scene;
}

scene::Scene cells(double material = 1) {
  auto scene = test::empty_scene();
  scene.mutable_material()->set_young_modulus(material * 10e9);
  auto& packing = *scene.mutable_particles()->mutable_cells();
  test::set_box(packing, 4, 2);
  packing.set_size(0.4);
  set_contacts(scene);
  scene.mutable_particles()->mutable_bonds();
  auto& fracture = *scene.mutable_material()->mutable_fracture();
  fracture.set_tensile_strength(material * 1e6);
  fracture.set_fracture_energy(100);
  fracture.set_cohesion(material * 4e6);
  return scene;
}

using MakeScene = scene::Scene (*)(double);
class EachKind : public testing::TestWithParam<MakeScene> {};
INSTANTIATE_TEST_SUITE_P(Kinds, EachKind, testing::Values(lattice, cemented, cells));

// Held at the left end and torn at the right one.
wire::Energies torn(scene::Scene scene, int& cracks) {
  auto& particles = *scene.mutable_particles();
  auto& held = *particles.add_motions();
  held.mutable_where()->set_x_max(0.5);
  held.mutable_velocity()->set_x(0);
  held.mutable_velocity()->set_y(0);
  auto& pulled = *particles.add_motions();
  pulled.mutable_where()->set_x_min(3.5);
  pulled.mutable_velocity()->set_x(1);
  pulled.mutable_velocity()->set_y(0.5);
  test::InProcessRun run(scene, {}, 0.4);
  cracks = 0;
  run.dt = 4e-6;
  for (int n = 0; n < 300; ++n) cracks += run.advance().cracks_size();
  return run.predicted.energies();
}

// Requirement: a field of 2 is, until and while it breaks, a material with twice the modulus and the
// strength.
TEST_P(EachKind, OfUniformFactorsIsThatOfAnotherMaterial) {
  scene::Scene scattered = GetParam()(1);
  add_field(scattered, scene::Scatter::STIFFNESS, "1,1,2\n");
  add_field(scattered, scene::Scatter::STRENGTH, "1,1,2\n");
  int found_cracks = 0, cracks = 0;
  const wire::Energies found = torn(scattered, found_cracks), wanted = torn(GetParam()(2), cracks);
  EXPECT_GE(cracks, 5);
  EXPECT_EQ(found_cracks, cracks);
  EXPECT_NEAR(found.kinetic() / wanted.kinetic(), 1, 1e-9);
  EXPECT_NEAR(found.strain() / wanted.strain(), 1, 1e-9);
  EXPECT_NEAR(found.external_work() / wanted.external_work(), 1, 1e-9);
}

// Requirement: springs and strengths are those of the scene without a field, times the factors of the place.
TEST_P(EachKind, HasTheFactorsOfTheirPlace) {
  scene::Scene scene = GetParam()(1);
  const Model plain = read_model(scene);
  add_slopes(scene);
  const Model model = read_model(scene);
  ASSERT_EQ(model.bonds.size(), plain.bonds.size());
  for (std::size_t k = 0; k < plain.bonds.size(); ++k) {
    const Bond &one = plain.bonds[k], &other = model.bonds[k];
    const auto [x, y] = meeting_place(plain.discs, one.first, one.second);
    double stiffness = stiffness_at(x);
    if (one.law == Bond::Law::kFacet) {  // half of either cell, in series
      const double a = stiffness_at(plain.discs.x[one.first]), b = stiffness_at(plain.discs.x[one.second]);
      stiffness = 2 * a * b / (a + b);
    }
    const LinearContact none{0, 0, 0};
    const BondSprings before = stiffest_springs(plain, one, none),
                      after = stiffest_springs(model, other, none);
    EXPECT_NEAR(after.kn / before.kn, stiffness, 1e-12);
    EXPECT_NEAR(after.ks / before.ks, stiffness, 1e-12);
    EXPECT_NEAR(after.km, stiffness * before.km, 1e-12 * before.km);
    const auto strengths = [](const Model& of, const Bond& bond) -> std::pair<double, double> {
      if (bond.law == Bond::Law::kContactBond)
        return {of.contact_bonds[bond.number].tensile_strength, of.contact_bonds[bond.number].shear_strength};
      if (bond.law == Bond::Law::kParallelBond)
        return {of.parallel_bonds[bond.number].tensile_strength, of.parallel_bonds[bond.number].cohesion};
      const FacetLaw& law = of.facet_laws[of.facets[bond.number].law];
      return {law.tensile_strength, law.cohesion};
    };
    EXPECT_NEAR(strengths(model, other).first / strengths(plain, one).first, strength_at(y), 1e-12);
    EXPECT_NEAR(strengths(model, other).second / strengths(plain, one).second, strength_at(y), 1e-12);
  }
}

// Requirement: a bond that is stretched breaks when its force reaches its own strength.
TEST(ScatteredBond, BreaksAtItsOwnStrength) {
  constexpr double kStiffness = 1e9, kStrength = 1e5, kSpeed = 0.01;
  const auto break_time = [](double stiffness, double strength) {
    auto scene = test::placed_scene("x_m,y_m,radius_m\n0,0,0.5\n1,0,0.5\n");
    auto& particles = *scene.mutable_particles();
    particles.mutable_bonds()->set_normal_stiffness(kStiffness);
    particles.mutable_bonds()->set_shear_stiffness(kStiffness / 2);
    particles.mutable_bonds()->set_tensile_strength(kStrength);
    add_field(scene, scene::Scatter::STIFFNESS, "0,0,1\n1,0," + std::to_string(2 * stiffness - 1) + "\n");
    add_field(scene, scene::Scatter::STRENGTH, "0,0," + std::to_string(strength) + "\n");
    for (const double speed : {0.0, kSpeed}) {
      auto& motion = *particles.add_motions();
      (speed == 0 ? motion.mutable_where()->set_x_max(0.5) : motion.mutable_where()->set_x_min(0.5));
      motion.mutable_velocity()->set_x(speed);
      motion.mutable_velocity()->set_y(0);
    }
    test::InProcessRun run(scene);
    run.dt = 1e-6;
    while (run.advance().cracks_size() == 0 && run.next < 40'000) continue;
    return static_cast<double>(run.next) * run.dt;
  };
  for (const auto& [stiffness, strength] : {std::pair{1.0, 1.0}, {2.0, 1.0}, {1.0, 0.5}, {1.5, 3.0}})
    EXPECT_NEAR(break_time(stiffness, strength), strength * kStrength / (stiffness * kStiffness) / kSpeed,
                3e-6)
        << stiffness << ' ' << strength;
}

// Requirement: in series, the halves of a facet have together its stiffness, also where particles were
// numbered anew and an overlap took some of them away.
TEST(ScatteredCells, StandInSeries) {
  auto scene = cells();
  add_slopes(scene);
  Model model = read_model(scene);
  std::vector<double> centres;
  for (const double x : model.discs.x) centres.push_back(x < 1 ? 0 : 1);
  const std::vector<double> midpoints(model.bonds.size(), 1.0);
  model = weigh(model, {centres, midpoints, 1e-3});
  renumber(model);
  const Facets facets(model, 1);
  ASSERT_GT(facets.size(), 50u);
  for (std::uint32_t k = 0; k < facets.size(); ++k) {
    const FacetSet& set = facets.set();
    EXPECT_NEAR(set.share_1[k] + set.share_2[k], 2, 1e-12);
    const double x_1 = model.discs.x[set.first[k]], x_2 = model.discs.x[set.second[k]];
    EXPECT_NEAR(set.share_1[k] / set.share_2[k], stiffness_at(x_2) / stiffness_at(x_1), 1e-12);
  }
}

TEST(ScatteredLattice, TakesTheGeneralEngine) {
  auto scene = lattice();
  scene.mutable_particles()->set_engine(scene::Particles::AUTOMATIC);
  add_slopes(scene);
  const Model model = read_model(scene);
  EXPECT_EQ(choose_engine(scene::Particles::AUTOMATIC, model).told(),
            "general: bonds have different stiffnesses or strengths");
  adit::test::expect_refusal([&] { choose_engine(scene::Particles::LATTICE, model); }, "particles.engine",
                             "is lattice, but bonds have different stiffnesses or strengths");
}

TEST(ScatteredBonds, RefuseWrongFields) {
  auto scene = lattice();
  add_field(scene, scene::Scatter::STRENGTH, "0,0,-1\n");
  adit::test::expect_refusal([&] { read_model(scene); }, "particles.scatter[0].path",
                             "field.csv: the factor at (0, 0) m is -1");
}

}  // namespace
}  // namespace adit::dem::scatter_test

// Every scene of cells that cannot be computed: the error names the field and says what to do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "dem_server/model/reading/read_model.hpp"
#include "dem_server/participant/choose_engine.hpp"
#include "protocol/scene/fields/check_rules.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::cell_errors_test {
namespace {

// Cells of 0.1 m in a box of 2 m by 1 m, of concrete.
scene::Scene concrete() {
  auto scene = test::empty_scene();
  auto& cells = *scene.mutable_particles()->mutable_cells();
  test::set_box(cells, 2, 1);
  cells.set_size(0.1);
  auto& fracture = *scene.mutable_material()->mutable_fracture();
  fracture.set_tensile_strength(2.5e6);
  fracture.set_fracture_energy(100);
  fracture.set_compressive_strength(39e6);
  return scene;
}

void compute(const scene::Scene& scene) {
  protocol::check_rules(scene);
  choose_engine(scene.particles().engine(), read_model(scene));
}

using Case = adit::test::Refusal<std::function<void(scene::Scene&)>>;
class CellErrors : public testing::TestWithParam<Case> {};

TEST_P(CellErrors, NameTheFieldAndTheRemedy) {
  auto scene = concrete();
  GetParam().input(scene);
  adit::test::expect_refusal([&] { compute(scene); }, GetParam().path, GetParam().message);
}

TEST(CellErrors, TheSceneThatTheySpoilIsComputed) {
  EXPECT_NO_THROW(compute(concrete()));
}

scene::Fracture& fracture(scene::Scene& s) {
  return *s.mutable_material()->mutable_fracture();
}
scene::ParticleGroup& add_group(scene::Scene& s) {
  auto& group = *s.mutable_particles()->add_groups();
  group.set_name("part");
  return group;
}
template <class Annulus>
void set_lining(Annulus& annulus, double thickness) {
  test::set(*annulus.mutable_centre(), 1, 0.5);
  annulus.set_inner_radius(0.4 - thickness);
  annulus.set_outer_radius(0.4);
}

INSTANTIATE_TEST_SUITE_P(
    OfFracture, CellErrors,
    testing::Values(
        Case{"NoEnergy", "material.fracture.fracture_energy",
             "is 0 J/m^2, expected an energy per area above 0 J/m^2",
             [](auto& s) { fracture(s).set_fracture_energy(0); }},
        Case{"NoTension", "material.fracture.tensile_strength", "is 0 Pa, expected a pressure above 0 Pa",
             [](auto& s) { fracture(s).set_tensile_strength(0); }},
        Case{"WeakInCompression", "material.fracture.compressive_strength",
             "is too small: it makes the cohesion 3.837e+05 Pa, below the tensile_strength of 2.5e+06 Pa",
             [](auto& s) { fracture(s).set_compressive_strength(1e6); }},
        Case{"WeakInShear", "material.fracture.cohesion", "is too small",
             [](auto& s) {
               fracture(s).clear_compressive_strength();
               fracture(s).set_cohesion(1e6);
             }},
        Case{"NoCompression", "material.fracture", "give exactly one",
             [](auto& s) { fracture(s).clear_compressive_strength(); }},
        Case{"CompressionTwice", "material.fracture", "give exactly one",
             [](auto& s) { fracture(s).set_cohesion(10e6); }},
        Case{"SteepFriction", "material.fracture.friction_angle",
             "is 1.6 rad, expected an angle of at least 0 rad and below 1.57 rad",
             [](auto& s) { fracture(s).set_friction_angle(1.6); }},
        Case{"FrictionGrows", "material.fracture.residual_friction_angle", "is above friction_angle",
             [](auto& s) { fracture(s).set_residual_friction_angle(0.5); }},
        Case{"OfBonds", "particles.bonds.fracture.compressive_strength", "is too small",
             [](auto& s) {
               auto& own = *s.mutable_particles()->mutable_bonds()->mutable_fracture();
               own = fracture(s);
               own.set_compressive_strength(1e6);
             }}),
    adit::test::kRefusalName);

INSTANTIATE_TEST_SUITE_P(
    OfPacking, CellErrors,
    testing::Values(
        Case{"Incompressible", "material.poisson_ratio", "cells deform like a solid only from 0 to 0.45",
             [](auto& s) { s.mutable_material()->set_poisson_ratio(0.46); }},
        Case{"Auxetic", "material.poisson_ratio", "only from 0 to 0.45",
             [](auto& s) { s.mutable_material()->set_poisson_ratio(-0.1); }},
        Case{"ThinRing", "particles.cells.size",
             "is 0.1 m, more than half of the thickness of the ring, 0.15 m; give at most 0.075 m",
             [](auto& s) {
               auto& ring = *s.mutable_particles()->mutable_ring();
               set_lining(ring, 0.15);
               ring.set_segments(1);
             }},
        Case{"ThinLining", "particles.cells.size",
             "is 0.1 m, more than half of the thickness of the group `part`, 0.15 m; give at most 0.075 m",
             [](auto& s) { set_lining(*add_group(s).mutable_where()->mutable_annulus(), 0.15); }},
        Case{"TooMany", "particles.cells.size", "can be computed on this machine",
             [](auto& s) { s.mutable_particles()->mutable_cells()->set_size(1e-7); }},
        Case{"FinerIsCoarser", "particles.cells.finer[0].size",
             "is 0.2 m, but the other cells have 0.1 m; give less",
             [](auto& s) {
               auto& finer = *s.mutable_particles()->mutable_cells()->add_finer();
               finer.mutable_where()->set_x_min(1);
               finer.set_size(0.2);
             }},
        Case{"FinerNowhere", "particles.cells.finer[0].where", "selects no cells; widen it",
             [](auto& s) {
               auto& finer = *s.mutable_particles()->mutable_cells()->add_finer();
               finer.mutable_where()->set_x_min(1.5);
               finer.mutable_where()->set_x_max(0.5);
               finer.set_size(0.05);
             }},
        Case{"FinerGroup", "particles.cells.finer[0].where.group", "state the place by shapes",
             [](auto& s) {
               auto& finer = *s.mutable_particles()->mutable_cells()->add_finer();
               finer.mutable_where()->set_group("part");
               finer.set_size(0.05);
             }},
        Case{"ThinPartOfALining", "particles.cells.size",
             "more than half of the thickness of the ring, 0.15 m",
             [](auto& s) {
               auto& finer = *s.mutable_particles()->mutable_cells()->add_finer();
               finer.mutable_where()->set_x_min(1.2);
               finer.set_size(0.05);
               set_lining(*s.mutable_particles()->mutable_ring(), 0.15);
               s.mutable_particles()->mutable_ring()->set_segments(1);
             }},
        Case{"CrossedOutline", "particles.groups[0].where.polygon.corners",
             "names a corner twice, or sides that cross",
             [](auto& s) {
               auto& polygon = *add_group(s).mutable_where()->mutable_polygon();
               test::set(*polygon.add_corners(), 0.5, 0.2);
               test::set(*polygon.add_corners(), 1.5, 0.8);
               test::set(*polygon.add_corners(), 1.5, 0.2);
               test::set(*polygon.add_corners(), 0.5, 0.8);
             }},
        Case{"SmallCircle", "particles.groups[0].where.circle.radius",
             "is 0.04 m, less than half of the size of a cell, 0.1 m; give more, or smaller cells",
             [](auto& s) {
               auto& circle = *add_group(s).mutable_where()->mutable_circle();
               test::set(*circle.mutable_centre(), 1, 0.5);
               circle.set_radius(0.04);
             }},
        Case{"JointOfOnePoint", "particles.joints[0].to", "is the same place as `from`",
             [](auto& s) {
               auto& joint = *s.mutable_particles()->add_joints();
               test::set(*joint.mutable_from(), 1, 0.5);
               test::set(*joint.mutable_to(), 1, 0.5);
               joint.set_open(true);
             }}),
    adit::test::kRefusalName);

INSTANTIATE_TEST_SUITE_P(
    OfOtherParticles, CellErrors,
    testing::Values(
        Case{"Lattice", "particles.engine", "is lattice, but facets join cells",
             [](auto& s) { s.mutable_particles()->set_engine(scene::Particles::LATTICE); }},
        Case{"StrengthInNewton", "particles.bonds.tensile_strength", "give `fracture` here",
             [](auto& s) { s.mutable_particles()->mutable_bonds()->set_tensile_strength(1e6); }},
        Case{"MohrCoulomb", "particles.material.mohr_coulomb", "cells break by `fracture`",
             [](auto& s) {
               *s.mutable_particles()->mutable_material() = s.material();
               s.mutable_particles()->mutable_material()->mutable_mohr_coulomb()->set_cohesion(1e6);
             }},
        Case{"FractureOfDiscs", "particles.material.fracture", "only facets between `cells` break by it",
             [](auto& s) {
               *s.mutable_particles()->mutable_material() = s.material();
               s.mutable_particles()->clear_cells();
               auto& packing = *s.mutable_particles()->mutable_packing();
               test::set_box(packing, 2, 1);
               packing.set_radius(0.1);
             }},
        Case{"FractureOfBondsOfDiscs", "particles.bonds.fracture", "only facets between `cells` break by it",
             [](auto& s) {
               *s.mutable_particles()->mutable_bonds()->mutable_fracture() = fracture(s);
               s.mutable_particles()->clear_cells();
               auto& packing = *s.mutable_particles()->mutable_packing();
               test::set_box(packing, 2, 1);
               packing.set_radius(0.1);
             }}),
    adit::test::kRefusalName);

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

// Requirement: a scene is told the strengths that a laboratory would find: c and 15 degrees give a slope of
// 1.70 over a confining pressure.
TEST(CellNotes, SayTheStrengthsOfTheLaboratory) {
  EXPECT_THAT(read_model(concrete()).notes,
              Contains(HasSubstr("material.fracture: a laboratory finds 2.5 MPa in direct tension, 39 MPa in "
                                 "unconfined compression, and 1.7 of a confining pressure more")));
}

// Requirement: cells larger than a quarter of E' G_f / f_t^2 are warned of, with the size that would do,
// which is not. E' = 10 GPa / 1.2 in plane stress gives 0.1333 m and 0.0333 m.
TEST(CellNotes, WarnOfCellsTooLargeForTheFractureEnergy) {
  auto scene = concrete();
  EXPECT_THAT(read_model(scene).notes,
              Contains(AllOf(HasSubstr("particles.cells.size: is 0.1 m"), HasSubstr("= 0.133 m"),
                             HasSubstr("give at most 0.0333 m"))));
  scene.mutable_particles()->mutable_cells()->set_size(0.0333);
  EXPECT_THAT(read_model(scene).notes, Not(Contains(HasSubstr("particles.cells.size"))));
}

}  // namespace
}  // namespace adit::dem::cell_errors_test

// Requirement: bonds that take their strength from the material break at its tensile and compressive
// strength.
#include "dem_server/model/solid/strength_of_material.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "dem_server/model/initial_state/initial_state.hpp"
#include "dem_server/model/lattice.hpp"
#include "dem_server/model/reading/read_model.hpp"
#include "protocol/participant/warnings.hpp"
#include "tests/support/lattice_model.hpp"
#include "tests/unit/dem_server/cantilever_scene.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::strength_of_material_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kTension = 3e6, kCohesion = 8e6, kFriction = 0.7;

scene::Scene rock() {
  scene::Scene scene = test::cantilever_scene();
  auto& strength = *scene.mutable_material()->mutable_mohr_coulomb();
  strength.set_tension(kTension);
  strength.set_cohesion(kCohesion);
  strength.set_friction_angle(kFriction);
  scene.mutable_particles()->mutable_bonds()->set_strength_of_material(true);
  return scene;
}

// The largest normal and shear force in the bonds of a lattice under a stress.
struct Largest {
  double normal = 0, shear = 0;
};
Largest largest_under(const protocol::GroundStress& stress, const ContactBond& law, double radius) {
  const ContactBond unbreakable{law.stiffness.normal, law.stiffness.shear};
  Model model = test::lattice_in({0, 14 * radius, 0, 14 * radius}, radius, 2.0, unbreakable);
  set_initial_state([&stress](double, double) { return stress; }, model);
  Largest largest;
  for (const Bond& bond : model.bonds) {
    largest.normal = std::max(largest.normal, bond.at_rest.normal);
    largest.shear = std::max(largest.shear, std::abs(bond.at_rest.shear));
  }
  return largest;
}

TEST(StrengthOfMaterial, OfContactBondsIsReachedAtTheMaterialsStrengths) {
  const Model model = read_model(rock());
  ASSERT_EQ(model.contact_bonds.size(), 1u);
  const ContactBond& law = model.contact_bonds.front();
  const double radius = test::kCantileverRadius;
  EXPECT_NEAR(largest_under({kTension, 0, 0, {}}, law, radius).normal / law.tensile_strength, 1, 1e-12);
  const double compressive = 2 * kCohesion * std::cos(kFriction) / (1 - std::sin(kFriction));
  EXPECT_NEAR(largest_under({-compressive, 0, 0, {}}, law, radius).shear / law.shear_strength, 1, 1e-12);
  // Across the rows tension breaks bonds at a larger stress.
  const auto [kn, ks] = law.stiffness;
  const double across = kTension * (3 * kn + ks) / (2 * kn + ks);
  EXPECT_NEAR(largest_under({0, across, 0, {}}, law, radius).normal / law.tensile_strength, 1, 1e-12);
}

// Requirement: laws of the scene's material that particles do not compute are named, in a warning.
TEST(StrengthOfMaterial, WarnsWhereTheScenesLawDoesNotAct) {
  const auto warnings = [](const scene::Scene& scene) {
    std::vector<std::string> found;
    for (const std::string& note : read_model(scene).notes)
      if (note.starts_with(protocol::kWarning)) found.push_back(note);
    return found;
  };
  scene::Scene scene = rock();
  EXPECT_THAT(warnings(scene), IsEmpty());
  scene.mutable_particles()->clear_bonds();
  EXPECT_THAT(warnings(scene),
              ElementsAre(HasSubstr(
                  "`mohr_coulomb` of `material` does not act in the particles, which stay elastic")));
  scene.mutable_particles()->mutable_bonds()->set_tensile_strength(1e3);
  EXPECT_THAT(warnings(scene), IsEmpty());
  scene.mutable_material()->mutable_weak_plane()->set_dip_angle(0.5);
  EXPECT_THAT(warnings(scene), ElementsAre(HasSubstr("`weak_plane` of `material`")));
  *scene.mutable_particles()->mutable_material() = scene.material();
  scene.mutable_particles()->mutable_material()->clear_weak_plane();
  scene.mutable_particles()->mutable_material()->clear_mohr_coulomb();
  EXPECT_THAT(warnings(scene), IsEmpty());
}

TEST(StrengthOfMaterial, OfAStripIsScaledByItsRows) {
  scene::Scene scene = rock();
  scene.mutable_particles()->mutable_packing()->set_bends_as_solid(true);
  const Model model = read_model(scene);
  ASSERT_EQ(model.contact_bonds.size(), 3u);
  for (const ContactBond& law : model.contact_bonds)
    EXPECT_EQ(law.tensile_strength, model.contact_bonds.front().tensile_strength);
  EXPECT_GT(model.contact_bonds[1].factors.strength, 1);
}

TEST(StrengthOfMaterial, OfParallelBondsIsThatOfTheirCement) {
  scene::Scene scene = rock();
  auto& cement = *scene.mutable_particles()->mutable_bonds()->mutable_parallel();
  cement.set_normal_stiffness(1e12);
  cement.set_shear_stiffness(4e11);
  const Model model = read_model(scene);
  ASSERT_EQ(model.parallel_bonds.size(), 1u);
  EXPECT_EQ(model.parallel_bonds.front().tensile_strength, kTension);
  EXPECT_EQ(model.parallel_bonds.front().cohesion, kCohesion);
  EXPECT_EQ(model.parallel_bonds.front().tan_friction_angle, std::tan(kFriction));
}

// Without `tension` the apex of the cone counts; where two groups meet, the weaker material does.
TEST(StrengthOfMaterial, IsTheWeakerOfTwoMaterials) {
  scene::Scene scene = rock();
  auto& group = *scene.mutable_particles()->add_groups();
  group.set_name("weak");
  group.mutable_where()->set_x_max(5);
  *group.mutable_material() = scene.material();
  auto& strength = *group.mutable_material()->mutable_mohr_coulomb();
  strength.set_cohesion(1e6);
  strength.clear_tension();
  const Model model = read_model(scene);
  ASSERT_EQ(model.contact_bonds.size(), 3u);
  double least = kUnbreakable, most = 0;
  for (const ContactBond& law : model.contact_bonds) {
    least = std::min(least, law.tensile_strength);
    most = std::max(most, law.tensile_strength);
  }
  EXPECT_NEAR(most / least, kTension / (1e6 / std::tan(kFriction)), 1e-12);
}

// A tension beyond the apex of the cone, 8 MPa/tan(0.7) = 9.498 MPa, is cut, and the run tells it once.
TEST(StrengthOfMaterial, TellsWhereTheConeCutsTheTension) {
  scene::Scene scene = rock();
  auto& strength = *scene.mutable_material()->mutable_mohr_coulomb();
  strength.set_tension(20e6);
  auto& group = *scene.mutable_particles()->add_groups();
  group.set_name("same");
  group.mutable_where()->set_x_max(5);
  EXPECT_THAT(read_model(scene).notes, testing::ElementsAre(testing::AllOf(
                                           testing::HasSubstr("material.mohr_coulomb.tension: is 2e+07 Pa"),
                                           testing::HasSubstr("9.5e+06 Pa"))));
  strength.set_tension(9.55e6);  // 0.5 % beyond
  EXPECT_THAT(read_model(scene).notes, testing::IsEmpty());
  strength.clear_tension();
  EXPECT_THAT(read_model(scene).notes, testing::IsEmpty());
}

// Cement between two groups is the weaker in each of its strengths, and the softer in series.
TEST(Cement, BetweenGroupsIsTheWeaker) {
  auto scene = test::square_scene(4, 1);
  auto& p = *scene.mutable_particles();
  auto& weak = *p.mutable_bonds();
  weak.mutable_parallel()->set_normal_stiffness(2e11);
  weak.mutable_parallel()->set_shear_stiffness(1e11);
  weak.mutable_parallel()->set_tensile_strength(2e6);
  weak.mutable_parallel()->set_cohesion(5e6);
  weak.mutable_parallel()->set_friction_angle(0.7);
  auto& group = *p.add_groups();
  group.set_name("lining");
  group.mutable_where()->set_x_min(2);
  *group.mutable_bonds() = weak;
  group.mutable_bonds()->mutable_parallel()->set_tensile_strength(3e6);
  group.mutable_bonds()->mutable_parallel()->set_cohesion(4e6);
  group.mutable_bonds()->mutable_parallel()->set_friction_angle(0.6);
  const Model model = read_model(scene);
  ASSERT_EQ(model.bonds.size(), 3u);
  const ParallelBond& between = model.parallel_bonds[model.bonds[1].number];
  EXPECT_EQ(between.tensile_strength, 2e6);
  EXPECT_EQ(between.cohesion, 4e6);
  EXPECT_EQ(between.tan_friction_angle, std::tan(0.6));
  EXPECT_DOUBLE_EQ(between.normal_stiffness, 2e11) << "two halves in series";
}

}  // namespace
}  // namespace adit::dem::strength_of_material_test

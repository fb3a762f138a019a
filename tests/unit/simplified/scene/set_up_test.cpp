// Scenes that cannot be computed are refused at the wrong field; all others are divided into pieces as they
// ask.
#include <gmock/gmock.h>

#include "simplified/run.hpp"
#include "simplified/scene/ground.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/simplified/scenes.hpp"

namespace adit::simplified::set_up_test {
namespace {

using ::testing::HasSubstr;
using testing::scene_of;
using testing::tunnel;

void expect_refusal(const scene::Scene& scene, const std::string& path, const std::string& text) {
  adit::test::expect_refusal([&] { set_up(scene); }, path, text);
}

// Requirement: every joint and every end of a section is a node, and no piece is longer than was asked for.
TEST(Divide, PutsNodesOnJointsAndKeepsTheElementLength) {
  scene::Tunnel scene = tunnel().simplified().tunnel();
  scene.mutable_sections(0)->set_to(90);
  scene.mutable_sections(1)->set_from(90);
  const Line line = divide(scene);
  ASSERT_EQ(line.joints.size(), 7U);
  for (std::size_t j = 0; j < 7; ++j) EXPECT_DOUBLE_EQ(line.nodes[line.joint_node[j]], 25.0 * (1.0 + j));
  EXPECT_THAT(line.nodes, ::testing::Contains(90.0));
  EXPECT_DOUBLE_EQ(line.nodes.back(), 200);
  for (std::size_t i = 0; i < line.section.size(); ++i) {
    EXPECT_LE(line.nodes[i + 1] - line.nodes[i], 1 + 1e-9);
    EXPECT_EQ(line.section[i], line.nodes[i] < 90 ? 0U : 1U);
  }
}

// Requirement: a place that two groups name belongs to the first of them.
TEST(Divide, GivesAPlaceToTheFirstGroupThatNamesIt) {
  scene::Tunnel scene = tunnel().simplified().tunnel();
  *scene.add_joints() = scene.joints(0);
  scene.mutable_joints(0)->clear_from();
  scene.mutable_joints(0)->clear_to();
  scene.mutable_joints(0)->clear_spacing();
  scene.mutable_joints(0)->add_at(75);
  const Line line = divide(scene);
  ASSERT_EQ(line.joints.size(), 7U);
  for (const PlacedJoint& joint : line.joints) EXPECT_EQ(joint.group, joint.chainage == 75 ? 0U : 1U);
}

TEST(SetUp, RefusesAGapInTheChainage) {
  scene::Scene scene = tunnel();
  scene.mutable_simplified()->mutable_tunnel()->mutable_sections(1)->set_from(110);
  expect_refusal(scene, "simplified.tunnel.sections[1].from", "a gap of 10 m");
}

TEST(SetUp, RefusesJointsOutsideTheTunnelAndJointsThatHoldNothing) {
  scene::Scene scene = tunnel();
  scene.mutable_simplified()->mutable_tunnel()->mutable_joints(0)->set_to(200);
  expect_refusal(scene, "simplified.tunnel.joints[0]", "at 200 m, which is not inside the tunnel");
  scene = tunnel();
  scene.mutable_simplified()->mutable_tunnel()->mutable_joints(0)->clear_axial_stiffness();
  expect_refusal(scene, "simplified.tunnel.joints[0]", "neither `axial_stiffness` nor `gasket`");
}

TEST(SetUp, RefusesAGasketWhoseCurveFalls) {
  for (const auto model : {scene::Simplified::BEAM, scene::Simplified::CHAIN}) {
    scene::Scene scene = tunnel();
    scene.mutable_simplified()->set_model(model);
    auto& gasket = *scene.mutable_simplified()->mutable_tunnel()->mutable_joints(0)->mutable_gasket();
    for (const double c : {0.0, 0.1, 0.2}) gasket.add_compression(c);
    for (const double f : {0.0, 2e6, 1e6}) gasket.add_force(f);
    gasket.set_installed_force(1e6);
    expect_refusal(scene, "simplified.tunnel.joints[0].gasket.force[2]", "");
  }
}

TEST(SetUp, RefusesWhatTheModelCannotDo) {
  scene::Scene scene = tunnel();
  scene.mutable_simplified()->set_model(scene::Simplified::CHAIN);
  scene.mutable_simplified()->mutable_soil_springs()->set_slip_force(1e6);
  expect_refusal(scene, "simplified.soil_springs.slip_force", "needs the model beam");
  scene = tunnel();
  scene.mutable_simplified()->set_model(scene::Simplified::COLUMN);
  expect_refusal(scene, "simplified.ground", "is missing");
  scene = tunnel();
  scene.mutable_simplified()->mutable_soil_springs()->clear_axial();
  expect_refusal(scene, "simplified.soil_springs", "no `ground` from which to derive");
  scene = tunnel();
  scene.mutable_continuum();
  expect_refusal(scene, "continuum", "is given beside `simplified`");
  scene = tunnel();
  scene.mutable_time()->clear_dt();
  expect_refusal(scene, "time.dt", "is missing");
  scene = tunnel();
  scene.mutable_simplified()->mutable_stations(0)->set_chainage(201);
  expect_refusal(scene, "simplified.stations[0].chainage", "outside");
}

scene::Section section(double width, double height) {
  scene::Section section;
  section.set_width(width);
  section.set_height(height);
  return section;
}

// Requirement: the derived stiffness is that of physics.md's worked case, 1.661e8 N/m^2.
TEST(Ground, DerivesTheSoilSpringsOfStJohnAndZahrah) {
  const scene::Scene scene = scene_of(R"(simplified {
    ground { profiles { chainage: 0 layers { thickness: 40 shear_velocity: 200 density: 1900 poisson_ratio: 0.45 } } }
    soil_springs { wavelength: 400 } })");
  EXPECT_NEAR(soil_stiffness(scene.simplified(), 10, section(37.95, 11.4)).lateral, 1.661e8, 5e4);
}

// Requirement: a tunnel between two layers has springs of both, by the share of its height in each; the
// lowest layer goes on below, and no layer above the surface.
TEST(Ground, SoilSpringsAreTheMeanOverTheTunnelsHeight) {
  const auto lateral = [](double depth) {
    scene::Scene scene = scene_of(R"(simplified {
      ground { profiles { chainage: 0 layers { thickness: 20 shear_velocity: 100 density: 2000 }
                                      layers { thickness: 5 shear_velocity: 300 density: 2000 } } }
      soil_springs { wavelength: 400 } })");
    auto& axis = *scene.mutable_simplified()->mutable_tunnel()->add_axis();
    axis.set_chainage(0);
    axis.set_depth(depth);
    return soil_stiffness(scene.simplified(), 0, section(7, 8)).lateral;
  };
  const double soft = lateral(10), stiff = lateral(40);
  EXPECT_NEAR(stiff, 9 * soft, 1e-9 * stiff);
  EXPECT_NEAR(lateral(22), 0.25 * soft + 0.75 * stiff, 1e-9 * stiff);
  EXPECT_NEAR(lateral(1), soft, 1e-9 * soft);
}

// Requirement: between two profiles every layer is the mean of theirs by distance, beyond them it is theirs.
TEST(Ground, InterpolatesProfiles) {
  const scene::Scene scene = scene_of(R"(simplified { ground {
    profiles { chainage: 0 layers { thickness: 10 shear_velocity: 100 density: 1800 } }
    profiles { chainage: 100 layers { thickness: 30 shear_velocity: 300 density: 2000 } } } })");
  const scene::Layer layer = profile_at(scene.simplified().ground(), 25).layers(0);
  EXPECT_DOUBLE_EQ(layer.thickness(), 15);
  EXPECT_DOUBLE_EQ(layer.shear_velocity(), 150);
  EXPECT_DOUBLE_EQ(layer.density(), 1850);
  EXPECT_DOUBLE_EQ(profile_at(scene.simplified().ground(), 500).layers(0).thickness(), 30);
}

}  // namespace
}  // namespace adit::simplified::set_up_test

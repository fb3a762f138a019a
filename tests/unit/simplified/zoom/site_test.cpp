// The ground at a place, for a model of the tunnel's cross-section.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "simplified/run.hpp"
#include "simplified/zoom/site.hpp"
#include "tests/support/read_motion.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/simplified/scenes.hpp"

namespace adit::simplified::site_test {
namespace {

// A layer of rock on rock without damping, in which a wave of the outcrop rises unchanged to the tunnel's
// axis.
scene::Scene rock_tunnel() {
  scene::Scene scene = testing::tunnel();
  auto& simplified = *scene.mutable_simplified();
  simplified.mutable_excitation()->set_through_ground(true);
  simplified.mutable_excitation()->mutable_motion()->set_baseline(false);
  simplified.mutable_ground()->set_modes(40);
  simplified.mutable_ground()->mutable_rock()->set_density(2000);
  simplified.mutable_ground()->mutable_rock()->set_shear_velocity(400);
  scene::SoilProfile& profile = *simplified.mutable_ground()->add_profiles();
  profile.set_chainage(0);
  scene::Layer& layer = *profile.add_layers();
  layer.set_thickness(40);
  layer.set_density(2000);
  layer.set_shear_velocity(400);
  layer.set_damping_ratio(0);
  simplified.mutable_ground()->set_joined(false);
  simplified.mutable_ground()->set_column_spacing(10);
  return scene;
}

// Requirement: the base at a chainage has the scene's motion, later by the way of the wave along the tunnel;
// the tunnel's ground has the velocity that this outcrop gives the surface, later by the way through the
// layer.
TEST(SiteMotion, IsTheOutcropAndWhatItMakesOfTheGroundAtTheTunnel) {
  const scene::Scene scene = rock_tunnel();
  const auto setup = set_up(scene);
  const SiteMotion site = site_motion(shake(setup), setup.clock.dt, 150);
  const auto passage = static_cast<std::size_t>(std::lround(150 / 300. / setup.clock.dt));
  const auto rise = static_cast<std::size_t>(std::lround(40 / 400. / setup.clock.dt));
  const std::vector<double>& given = setup.motion.motion.acceleration;
  const std::vector<double> velocity = motion::integrate(setup.motion.motion).velocity;
  double largest = 0, of_base = 0, of_velocity = 0, fastest = 0;
  for (std::size_t n = 0; n + passage + rise < site.base_acceleration.size(); ++n) {
    largest = std::max(largest, std::abs(given[n]));
    fastest = std::max(fastest, std::abs(velocity[n]));
    of_base = std::max(of_base, std::abs(site.base_acceleration[n + passage] - given[n]));
    of_velocity = std::max(of_velocity, std::abs(site.tunnel_velocity[n + passage + rise] - velocity[n]));
  }
  EXPECT_NEAR(largest, 3, 0.01);
  EXPECT_LT(of_base, 1e-6 * largest);
  EXPECT_LT(of_velocity, 0.02 * fastest);
}

// Requirement: the file of the base is a record that a scene can read.
TEST(SiteFiles, HoldARecordOfTheBase) {
  const test::ScratchFolder folder;
  const scene::Scene scene = rock_tunnel();
  const SiteMotion motion{0.01, {0, 1.5, -2.25}, {0, 0.1, 0.2}};
  write_site(folder.path(), "opening", scene.simplified().ground(), motion, 80);
  const motion::Motion base = adit::test::read_motion(folder / "opening_base.csv");
  EXPECT_DOUBLE_EQ(base.dt, 0.01);
  EXPECT_EQ(base.acceleration, motion.base_acceleration);
  const auto text = [&](const char* name) {
    std::ifstream file(folder / name);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  EXPECT_EQ(
      text("opening_ground.csv"),
      "time_s,base_acceleration_m_per_s2,ground_velocity_m_per_s\n0,0,0\n0.01,1.5,0.1\n0.02,-2.25,0.2\n");
  EXPECT_EQ(
      text("opening_profile.csv"),
      "bottom_m,shear_velocity_m_per_s,density_kg_per_m3,poisson_ratio,damping_ratio\n40,400,2000,0.45,0\n");
}

// Requirement: where the motion acts on the tunnel directly there is no base.
TEST(SiteMotion, IsEmptyWithoutSoilColumns) {
  const scene::Scene scene = testing::tunnel();
  const auto setup = set_up(scene);
  EXPECT_TRUE(site_motion(shake(setup), setup.clock.dt, 100).base_acceleration.empty());
}

}  // namespace
}  // namespace adit::simplified::site_test

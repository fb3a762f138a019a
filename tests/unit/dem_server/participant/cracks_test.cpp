// Requirement: a crack between two discs lies where they touched, across the line of their centres, as long
// as what held them is wide, whatever their sizes and their order.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/unit/dem_server/in_process_run.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::cracks_test {
namespace {

constexpr double kSmall = 1, kLarge = 3, kAlongX = 0.6, kAlongY = 0.8;

void set(auto& velocity, double x, double y) {
  velocity.set_x(x);
  velocity.set_y(y);
}

// A small disc, and a large one that is drawn away from it.
scene::Scene two_discs(bool small_first) {
  const double distance = kSmall + kLarge;
  const std::string small = "0,0,1\n", large = std::to_string(distance * kAlongX) + "," +
                                               std::to_string(distance * kAlongY) + ",3\n";
  auto scene = test::placed_scene("x_m,y_m,radius_m\n" + (small_first ? small + large : large + small));
  auto& particles = *scene.mutable_particles();
  particles.mutable_bonds()->set_tensile_strength(1e3);
  auto &held = *particles.add_motions(), &drawn = *particles.add_motions();
  held.mutable_where()->set_x_max(1);
  set(*held.mutable_velocity(), 0, 0);
  drawn.mutable_where()->set_x_min(1);
  set(*drawn.mutable_velocity(), 1e-3 * kAlongX, 1e-3 * kAlongY);
  return scene;
}

wire::Crack first_crack(const scene::Scene& scene) {
  test::InProcessRun run(scene);
  while (run.advance().cracks_size() == 0)
    if (run.next > 100000) throw std::runtime_error("no crack");
  return run.predicted.cracks(0);
}

void expect_between_the_discs(const wire::Crack& crack, double length) {
  EXPECT_EQ(crack.mode(), wire::Crack::TENSILE);
  EXPECT_NEAR(crack.x(), kSmall * kAlongX, 1e-12);
  EXPECT_NEAR(crack.y(), kSmall * kAlongY, 1e-12);
  EXPECT_NEAR(crack.orientation(), -std::atan2(kAlongX, kAlongY), 1e-12);
  EXPECT_NEAR(crack.length(), length, 1e-12);
  EXPECT_EQ(crack.parent_a(), 0u);
  EXPECT_EQ(crack.parent_b(), 1u);
}

// Of a contact bond: the edge of the smaller disc's hexagonal cell.
TEST(Cracks, OfAContactBondLieWhereUnequalDiscsTouched) {
  for (const bool small_first : {true, false})
    expect_between_the_discs(first_crack(two_discs(small_first)), 2 * kSmall / std::numbers::sqrt3);
}

TEST(Cracks, OfAParallelBondAreAsLongAsItsStrip) {
  for (const bool small_first : {true, false}) {
    auto scene = two_discs(small_first);
    auto& cement = *scene.mutable_particles()->mutable_bonds()->mutable_parallel();
    cement.set_normal_stiffness(1e9);
    cement.set_shear_stiffness(1e9);
    cement.set_tensile_strength(1e3);
    cement.set_width(0.8);
    scene.mutable_particles()->mutable_bonds()->clear_tensile_strength();
    expect_between_the_discs(first_crack(scene), 0.8 * 2 * kSmall);
  }
}

}  // namespace
}  // namespace adit::dem::cracks_test

// Requirement: a wall whose velocity changes moves as far as its velocity says, to second order: by v t^2 /
// 2T while it rises evenly from 0 to v in the time T.
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include "tests/unit/dem_server/in_process_run.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::walls_test {
namespace {

constexpr double kStiffness = 1e8, kSpeed = 1e-2, kRise = 1e-3;
constexpr int kSteps = 50;

// A disc that is held, on a wall that rises: the force says how far.
scene::Scene pressed_disc() {
  auto scene = test::placed_scene("x_m,y_m,radius_m\n0,0,0.1\n");
  EXPECT_TRUE(google::protobuf::TextFormat::MergeFromString(R"(particles {
    contacts { normal_stiffness: 1e8 shear_stiffness: 0 }
    motions { where {} velocity { x: 0 y: 0 } spin: 0 }
    walls { name: "floor" from { x: -1 y: -0.1 } to { x: 1 y: -0.1 }
            velocity { y: 1e-2 time { table { time: 0 time: 1e-3 value: 0 value: 1 } } } }
    histories { name: "force" quantity: FORCE_Y wall: "floor" }
  })",
                                                            &scene));
  return scene;
}

TEST(Walls, MoveAsFarAsTheirChangingVelocitySays) {
  test::InProcessRun run(pressed_disc());
  run.dt = kRise / kSteps;
  for (int n = 0; n <= kSteps; ++n) {
    const double t = n * run.dt, moved = kSpeed * t * t / (2 * kRise);
    EXPECT_NEAR(run.advance().histories(0), -kStiffness * moved, 1e-9 * kStiffness * kSpeed * kRise) << n;
  }
}

}  // namespace
}  // namespace adit::dem::walls_test

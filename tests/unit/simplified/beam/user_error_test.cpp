// Wrong input gets one sentence that names the place and what was expected.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocol/errors.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/simplified/beam/tunnels.hpp"

namespace adit::simplified::beam::user_error_test {
namespace {

using testing::HasSubstr;

Tunnel good() {
  Tunnel tunnel = immersed_tube(0, 200, 20, 1e8);
  tunnel.sections[0].to = 100;
  tunnel.sections.push_back(tunnel.sections[0]);
  tunnel.sections[1].from = 100;
  tunnel.sections[1].to = 200;
  Joint joint;
  joint.chainage = 100;
  joint.hydrostatic_force = 1e7;
  joint.gaskets = rectangular_gasket(kWidth, 11.4, 1, {{0, 0}, {0.1, 1e6}});
  tunnel.joints = {joint};
  return tunnel;
}

void expect_error(const Tunnel& tunnel, const std::string& path, const std::string& text) {
  adit::test::expect_refusal([&] { run(tunnel, still(), statics()); }, path, text);
}

TEST(UserError, GoodTunnelRuns) {
  EXPECT_NO_THROW(run(good(), still(), statics()));
}

TEST(UserError, GapAndOverlapInChainage) {
  Tunnel tunnel = good();
  tunnel.sections[1].from = 120;
  expect_error(tunnel, "sections[1].from",
               "gap in chainage: section 0 ends at 100 m and section 1 starts at 120 m");
  tunnel.sections[1].from = 90;
  expect_error(tunnel, "sections[1].from", "overlap in chainage");
  tunnel = good();
  tunnel.soil[1].chainage = 150;
  expect_error(tunnel, "soil", "the soil is given from 0 m to 150 m and the tunnel runs from 0 m to 200 m");
}

TEST(UserError, JointCurveNotMonotone) {
  Tunnel tunnel = good();
  tunnel.joints[0].gaskets[1].compression = {{0, 0}, {0.1, 2e6}, {0.15, 1e6}};
  expect_error(tunnel, "joints[0].gaskets[1].compression[2]",
               "not monotone: (0.15 m, 1e+06) follows (0.1 m, 2e+06)");
  tunnel.joints[0].gaskets[1].compression = {{0, 0}, {0.1, 2e6}, {0.15, 2e6}};
  expect_error(tunnel, "joints[0].gaskets[1].compression[2]", "not monotone");
  tunnel.joints[0].gaskets[1].compression = {{0.01, 0}, {0.1, 2e6}};
  expect_error(tunnel, "joints[0].gaskets[1].compression[0]", "must start at (0 m, 0 N/m)");
  tunnel = good();
  tunnel.joints[0].lateral = key(-1e9, 0.01);
  expect_error(tunnel, "joints[0].lateral", "must not be negative");
}

TEST(UserError, JointsOutOfOrderOrOutside) {
  Tunnel tunnel = good();
  tunnel.joints.push_back(tunnel.joints[0]);
  expect_error(tunnel, "joints[1].chainage", "in order and inside the tunnel");
  tunnel.joints[1].chainage = 200;
  expect_error(tunnel, "joints[1].chainage", "between 0 m and 200 m");
  tunnel = good();
  tunnel.joints[0].gaskets.clear();
  expect_error(tunnel, "joints[0].hydrostatic_force", "no gasket to carry it");
}

TEST(UserError, GroundThatLiquefiesOutOfRange) {
  for (const double share : {0.0, 1.1}) {
    Tunnel tunnel = good();
    tunnel.soil[1].liquefied = share;
    expect_error(tunnel, "soil[1].liquefied", "above 0 and at most 1");
  }
  Tunnel tunnel = good();
  tunnel.soil[0].uplift = std::numeric_limits<double>::infinity();
  expect_error(tunnel, "soil[0].uplift", "must be finite");
}

TEST(UserError, ValuesOutOfRange) {
  Tunnel tunnel = good();
  tunnel.sections[1].area = 0;
  expect_error(tunnel, "sections[1].area", "must be positive, got 0 m^2");
  tunnel = good();
  tunnel.soil[1].springs[kVertical].slip_force = -1;
  expect_error(tunnel, "soil[1].springs[2].slip_force", "must be positive");
  tunnel = good();
  tunnel.soil[0].springs[kAxial].hardening = 1;
  expect_error(tunnel, "soil[0].springs[0].hardening", "must be in [0, 1)");
  tunnel = good();
  tunnel.element_length = 0;
  expect_error(tunnel, "element_length", "must be positive");
}

TEST(UserError, ATubeThatIsFreeToMove) {
  Tunnel tunnel = good();
  for (auto& station : tunnel.soil) station.springs[kVertical].stiffness = 0;
  expect_error(tunnel, "soil", "free to move");
}

TEST(UserError, RunOptions) {
  RunOptions options = statics();
  options.stations = {250};
  EXPECT_THROW(run(good(), still(), options), protocol::UserError);
  options = statics();
  options.dt = 0;
  EXPECT_THROW(run(good(), still(), options), protocol::UserError);
  options = statics();
  options.scheme = newmark(0.1, 0.5);
  EXPECT_THROW(run(good(), still(), options), protocol::UserError);
}

TEST(UserError, MotionShorterThanAskedOrUnequal) {
  StationMotions motions;
  motions.dt = 0.01;
  motions.chainages = {0, 200};
  motions.displacement[kLateral] = {{0, 0.1, 0}, {0, 0.2, 0}};
  RunOptions options = statics();
  options.dt = 0.01;
  options.steps = 2;
  EXPECT_NO_THROW(run(good(), interpolated(motions), options));
  options.steps = 3;
  adit::test::expect_refusal([&] { run(good(), interpolated(motions), options); }, "displacement",
                             "the ground motion ends at 0.02 s, but 0.03 s is asked");
  motions.displacement[kLateral][1].pop_back();
  EXPECT_THROW(interpolated(motions), protocol::UserError);
  motions.displacement[kLateral].pop_back();
  EXPECT_THROW(interpolated(motions), protocol::UserError);
}

// Between stations and steps the motion is linear; beyond the outer stations it is theirs.
TEST(StationMotions, AreInterpolatedLinearly) {
  StationMotions motions;
  motions.dt = 0.1;
  motions.chainages = {0, 100};
  motions.displacement[kAxial] = {{0, 1, 5}, {2, 4, 8}};
  const GroundMotion motion = interpolated(motions);
  GroundState state;
  for (auto* kind : {&state.displacement, &state.velocity})
    for (auto& values : *kind) values.assign(3, -1.0);
  const std::vector<double> chainages = {-10, 25, 100};
  motion(0.05, chainages, state);
  EXPECT_THAT(state.displacement[kAxial],
              testing::ElementsAre(testing::DoubleEq(0.5), testing::DoubleEq(1.125), testing::DoubleEq(3)));
  motion(0.175, chainages, state);
  EXPECT_THAT(state.displacement[kAxial],
              testing::ElementsAre(testing::DoubleEq(4), testing::DoubleEq(4.75), testing::DoubleEq(7)));
  EXPECT_THAT(state.velocity[kVertical], testing::Each(0.0));
}

}  // namespace
}  // namespace adit::simplified::beam::user_error_test

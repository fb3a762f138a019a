// Joints: a gasket carries compression only, and opens when the tension exceeds its compression by the water.
#include <gtest/gtest.h>

#include "tests/unit/simplified/beam/tunnels.hpp"

namespace adit::simplified::beam::joint_test {
namespace {

constexpr double kHydrostatic = 171e6, kHeight = 11.4, kLength = 180;
const std::vector<CurvePoint> kRubber = {{0, 0}, {0.05, 0.4e6}, {0.10, 1.4e6}, {0.15, 4e6}};  // hardens

Joint immersion_joint(double chainage) {
  Joint joint;
  joint.chainage = chainage;
  joint.hydrostatic_force = kHydrostatic;
  joint.gaskets = rectangular_gasket(kWidth, kHeight, 4, kRubber);
  return joint;
}

Tunnel two_halves() {
  Tunnel tunnel = immersed_tube(-kLength / 2, kLength / 2, 22.5, 1);
  tunnel.start = tunnel.end = Portal::kFixed;
  tunnel.joints = {immersion_joint(0)};
  return tunnel;
}

Results pulled_apart(const Tunnel& tunnel, double by) {
  return run(tunnel, displaced(kAxial, [=](double x) { return by * x / kLength; }), statics());
}

TEST(Gasket, TheHydrostaticForceCompressesItAsItsCurveSays) {
  const double perimeter = 2 * (kWidth + kHeight);
  const double expected = compression_under(kRubber, kHydrostatic / perimeter);
  EXPECT_NEAR(pulled_apart(two_halves(), 0).joints[0].installed_compression, expected, 1e-12);
  EXPECT_GT(expected, 0.10);
}

// At rest on ground that does not move nothing is left but rounding of the forces that cancel: no step fails
// on it.
TEST(Gasket, StaysAtRestWithoutMotion) {
  Tunnel tunnel = two_halves();
  tunnel.joints[0].hydrostatic_force = 171.234567e6;
  RunOptions options = statics();
  options.dt = 0.01;
  options.steps = 20;
  const Results results = run(tunnel, still(), options);
  EXPECT_LT(results.joints[0].largest_opening, 1e-12);
}

TEST(Gasket, OpensWhenTensionPassesThePreCompressionAndNotBefore) {
  const Tunnel tunnel = two_halves();
  const double installed = pulled_apart(tunnel, 0).joints[0].installed_compression;
  const double limit =
      installed + kHydrostatic * kLength / (kYoung * kArea);  // gasket released, tube stretched
  for (const double share : {0.3, 0.9, 0.9999}) {
    const Results closed = pulled_apart(tunnel, share * limit);
    EXPECT_EQ(closed.joints[0].contact_lost_time, std::numeric_limits<double>::infinity()) << share;
    EXPECT_LT(closed.axial_force.maximum[0], kHydrostatic);
    EXPECT_LT(closed.joints[0].largest_opening, installed);
  }
  for (const double share : {1.0001, 1.5}) {
    const Results open = pulled_apart(tunnel, share * limit);
    EXPECT_EQ(open.joints[0].contact_lost_time, 0) << share;
    EXPECT_NEAR(open.axial_force.maximum[0], kHydrostatic, 1e-6 * kHydrostatic);
    EXPECT_NEAR(open.joints[0].largest_opening, installed + (share - 1) * limit, 1e-6);
  }
}

TEST(Gasket, BendingOpensOneSideAndClosesTheOther) {
  Tunnel tunnel = immersed_tube(-kLength / 2, kLength / 2, 22.5, 1e8);
  tunnel.joints = {immersion_joint(0)};
  const Results results =
      run(tunnel, displaced(kLateral, [](double x) { return 1e-3 * std::abs(x); }), statics());
  EXPECT_GT(results.joints[0].largest_opening, 0.01);
  EXPECT_GT(results.joints[0].largest_compression, 0.01);
}

TEST(Omega, LimitIsReportedWhenItIsPassed) {
  Tunnel tunnel = two_halves();
  tunnel.joints[0].omega_limit = 0.05;
  EXPECT_EQ(pulled_apart(tunnel, 0.04).joints[0].omega_exceeded_time,
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(pulled_apart(tunnel, 0.3).joints[0].omega_exceeded_time, 0);
}

// After the gasket has let go, the cables alone carry what comes beyond the pre-compression.
TEST(Cable, PullsOnlyBeyondItsSlack) {
  Tunnel tunnel = two_halves();
  const double stiffness = 1e9, slack = 0.2, by = 0.5;
  tunnel.joints[0].springs = {{0, 0, cable(stiffness, slack)}};
  const Results results = pulled_apart(tunnel, by);
  const double opening = results.joints[0].largest_opening;
  ASSERT_GT(opening, slack);
  EXPECT_NEAR(results.axial_force.maximum[0], kHydrostatic + stiffness * (opening - slack),
              1e-5 * kHydrostatic);
  const Results short_of_slack = pulled_apart(tunnel, 0.15);
  EXPECT_NEAR(short_of_slack.axial_force.maximum[0], pulled_apart(two_halves(), 0.15).axial_force.maximum[0],
              1);
}

// Two rigid halves pushed sideways against each other: free within the clearance, then held by the key.
TEST(ShearKey, EngagesBeyondItsClearance) {
  const double soil = 1e6, stiffness = 1e9, clearance = 0.02;
  const auto offset = [&](double step) {
    Tunnel tunnel = immersed_tube(-kLength / 2, kLength / 2, 22.5, soil);
    tunnel.joints = {immersion_joint(0)};
    tunnel.joints[0].lateral = key(stiffness, clearance);
    return run(tunnel, displaced(kLateral, [=](double x) { return x < 0 ? -step / 2 : step / 2; }), statics())
        .joints[0]
        .largest_offset;
  };
  EXPECT_NEAR(offset(0.9 * clearance), 0.9 * clearance, 1e-6);
  const double held = offset(10 * clearance);
  EXPECT_GT(held, clearance);
  EXPECT_LT(held, 1.5 * clearance);
}

}  // namespace
}  // namespace adit::simplified::beam::joint_test

// Requirements on forces that are given point by point over an opening.
#include "protocol/springs/force_curve.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace adit::protocol::test::force_curve_test {
namespace {

// A gasket pressed by 2 kN when it is installed; it stiffens in compression and lets go at 4 mm.
const std::vector<double> kOpening{-2e-3, 0, 4e-3, 6e-3}, kForce{-10e3, -2e3, 0, 0};

// The force is linear between the points and keeps the outer slopes; the energy is its integral from where it
// vanishes first.
TEST(ForceCurve, IsPiecewiseLinearAndConserves) {
  const ForceCurve curve(kOpening, kForce);
  EXPECT_DOUBLE_EQ(curve.force(0), -2e3);
  EXPECT_DOUBLE_EQ(curve.force(-1e-3), -6e3);
  EXPECT_DOUBLE_EQ(curve.force(-3e-3), -14e3);
  EXPECT_DOUBLE_EQ(curve.force(1e-3), -1.5e3);
  EXPECT_DOUBLE_EQ(curve.force(8e-3), 0);
  EXPECT_DOUBLE_EQ(curve.steepest(), 4e6);
  EXPECT_DOUBLE_EQ(curve.slope(-3e-3), 4e6);
  EXPECT_DOUBLE_EQ(curve.slope(1e-3), 0.5e6);
  EXPECT_NEAR(curve.energy(4e-3), 0, 1e-15);
  EXPECT_NEAR(curve.energy(7e-3), 0, 1e-15);
  EXPECT_NEAR(curve.energy(0), 2e3 * 4e-3 / 2, 1e-12);
  EXPECT_NEAR(curve.energy(-3e-3), 4 + (2e3 + 14e3) / 2 * 3e-3, 1e-12);
}

// A force that stays the same around opening 0 is no place without force: energy counts from where it
// vanishes.
TEST(ForceCurve, HoldsTheEnergyOfASteadyForce) {
  const ForceCurve yielding({-4e-3, -2e-3, 2e-3}, {0, 5e3, 5e3});
  EXPECT_DOUBLE_EQ(yielding.energy(-4e-3), 0);
  EXPECT_NEAR(yielding.energy(0), 5e3 * (2e-3 / 2 + 2e-3), 1e-12);
}

}  // namespace
}  // namespace adit::protocol::test::force_curve_test

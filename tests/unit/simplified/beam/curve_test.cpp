// The force laws of joints.
#include <gtest/gtest.h>

#include "simplified/beam/model/curve.hpp"

namespace adit::simplified::beam::curve_test {
namespace {

const Curve kBent = {{{-0.1, -3}, {0, 0}, {0.2, 1}, {0.3, 1}}, 50, 7};

TEST(Curve, ForceFollowsThePointsAndTheEndSlopes) {
  EXPECT_DOUBLE_EQ(kBent.force(-0.2), -8);
  EXPECT_DOUBLE_EQ(kBent.force(-0.05), -1.5);
  EXPECT_DOUBLE_EQ(kBent.force(0.25), 1);
  EXPECT_DOUBLE_EQ(kBent.force(0.5), 1 + 7 * 0.2);
}

// The work over a path is the sum over its parts, and the same quadrature by many small steps.
TEST(Curve, WorkIsTheIntegralOfTheForce) {
  const double a = -0.25, b = 0.6;
  double sum = 0;
  const int n = 17000;
  for (int i = 0; i < n; ++i) sum += kBent.force(a + (b - a) * (i + 0.5) / n) * (b - a) / n;
  EXPECT_NEAR(kBent.work(a, b), sum, 1e-6);
  EXPECT_NEAR(kBent.work(a, 0.1) + kBent.work(0.1, b), kBent.work(a, b), 1e-14);
  EXPECT_DOUBLE_EQ(kBent.work(b, a), -kBent.work(a, b));
}

// The tangent of the mean force is its derivative by the end of the path.
TEST(Curve, TangentOfTheMeanForceIsItsDerivative) {
  for (const auto& [from, to] : {std::pair{-0.25, 0.6}, {0.6, -0.25}, {0.05, 0.15}, {0.25, 0.1}}) {
    const double h = 1e-6;
    const double slope = (kBent.mean(from, to + h).force - kBent.mean(from, to - h).force) / (2 * h);
    EXPECT_NEAR(kBent.mean(from, to).tangent, slope, 1e-6);
  }
}

TEST(Curve, CableKeyAndGasketAnswerOnOneSideOnlyOrBeyondTheirClearance) {
  EXPECT_EQ(cable(10, 0.5).force(0.4), 0);
  EXPECT_DOUBLE_EQ(cable(10, 0.5).force(0.7), 2);
  EXPECT_EQ(cable(10, 0.5).force(-3), 0);
  EXPECT_EQ(key(10, 0.1).force(0.05), 0);
  EXPECT_DOUBLE_EQ(key(10, 0.1).force(-0.3), -2);
  const Curve rubber = gasket({{0, 0}, {0.1, 1}, {0.2, 4}}, 1.9);
  EXPECT_NEAR(rubber.force(0), 0, 1e-15);
  EXPECT_NEAR(rubber.force(0.03), 0.9, 1e-12);
  EXPECT_NEAR(rubber.force(0.13), 1.9, 1e-12);
  EXPECT_NEAR(rubber.force(5), 1.9, 1e-12);
  EXPECT_NEAR(rubber.force(-0.17), 1.9 - 7, 1e-12);
}

}  // namespace
}  // namespace adit::simplified::beam::curve_test

// Requirements on reinforcing steel under strains that come and go.
#include "protocol/materials/steel_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fibre.hpp"

namespace adit::sections::test::steel_law_test {
namespace {

using protocol::SteelCurve;
using protocol::SteelLaw;
using protocol::SteelState;
using Bar = Fibre<SteelLaw, SteelState>;

const SteelLaw kCurved{200e9, 500e6, 0.01, SteelCurve::kMenegottoPinto};
const double kYield = kCurved.yield / kCurved.modulus;

double line(double strain) {
  return kCurved.yield + kCurved.hardening * kCurved.modulus * (strain - kYield);
}

// Requirement: a loop of a bar between +-eps dissipates its area, 2 f_y times the plastic range, whatever the
// hardening.
TEST(SteelLaw, LoopDissipatesItsArea) {
  for (const double b : {0.0, 0.01}) {
    const SteelLaw law{200e9, 500e6, b};
    Fibre<SteelLaw, SteelState> bar{law, {}};
    const double eps = 0.01, yield = law.yield / law.modulus;
    EXPECT_NEAR(bar.to(eps), law.yield + b * law.modulus * (eps - yield), 1);
    bar.to(-eps);
    bar.to(eps);
    const double before = bar.work - stored(law, bar.state);
    bar.to(-eps);
    bar.to(eps);
    const double plastic = 2 * (eps - bar.state.stress / law.modulus);
    EXPECT_NEAR(bar.work - stored(law, bar.state) - before, 2 * plastic * law.yield,
                2e-3 * 2 * plastic * law.yield);
  }
}

// Requirement: the first loading of Menegotto and Pinto's bar has the equation's stress at the yield strain,
// f_y (b + (1 - b)/2^(1/20)), and is on the line of hardening from three times that on.
TEST(SteelLaw, CurveMeetsTheLineOfHardening) {
  Bar bar{kCurved, {}};
  EXPECT_NEAR(bar.to(kYield), kCurved.yield * (0.01 + 0.99 / std::pow(2, 0.05)), 1);
  EXPECT_NEAR(bar.to(3 * kYield), line(3 * kYield), 1e-6 * kCurved.yield);
  Bar pressed{kCurved, {}};
  EXPECT_EQ(pressed.to(-3 * kYield), -bar.state.stress);
}

// Requirement: a reversal at 1 % strain rounds the next branch by the published numbers: the lines meet at x
// = 1, where the curve has b + (1 - b)/2^(1/R), R = 20 (1 - 0.925 xi/(0.15 + xi)).
TEST(SteelLaw, ReversalRoundsTheCurve) {
  Bar bar{kCurved, {}};
  const double from = bar.to(0.01);
  // Elastic from (0.01, from) to the line through (-eps_y, -f_y) with the slope of hardening.
  const double meets = (from - 200e9 * 0.01 + 0.99 * 500e6) / (200e9 * (0.01 - 1));
  const double xi = std::abs(meets + kYield) / kYield, R = 20 * (1 - 0.925 * xi / (0.15 + xi));
  const double drop = 200e9 * (meets - 0.01);
  EXPECT_NEAR(bar.to(meets, 1), from + drop * (0.01 + 0.99 / std::pow(2, 1 / R)), 1e-6 * 500e6);
  EXPECT_LT(R, 5);
}

// Requirement: loading again after small reversals leaves the curve where it was: it is never exceeded.
TEST(SteelLaw, SmallReversalsDoNotStiffen) {
  Bar smooth{kCurved, {}}, shaken{kCurved, {}};
  for (int i = 1; i <= 40; ++i) {
    const double goal = i * 0.25 * kYield, expected = smooth.to(goal);
    EXPECT_LE(shaken.to(goal), expected * (1 + 1e-12));
    EXPECT_GT(shaken.state.stress, 0.97 * expected);
    shaken.to(goal - 0.05 * kYield);
  }
}

// Requirement: whatever the history, the tangent never exceeds E, stress stays within the lines of hardening,
// and what is lost, counted over whole loops, grows.
TEST(SteelLaw, CurveStaysWithinItsLines) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> goal(-0.02, 0.02);
  Bar bar{kCurved, {}};
  for (int leg = 0; leg < 60; ++leg) {
    const double from = bar.strain, to = goal(random);
    for (int i = 1; i <= 300; ++i) {
      const double before = bar.state.stress, at = bar.strain;
      bar.to(from + (to - from) * i / 300, 1);
      EXPECT_LE((bar.state.stress - before) / (bar.strain - at), kCurved.modulus * (1 + 1e-6));
      EXPECT_LE(bar.state.stress, line(bar.strain) * (1 + 1e-9));
      EXPECT_GE(bar.state.stress, -line(-bar.strain) * (1 + 1e-9));
    }
  }
  EXPECT_GT(bar.work, 0);
}

// Requirement: a bar that was strained beyond its rupture bears nothing from the next step on, and all of its
// work is lost.
TEST(SteelLaw, BreaksBeyondItsRupture) {
  for (const SteelCurve curve : {SteelCurve::kBilinear, SteelCurve::kMenegottoPinto}) {
    const SteelLaw law{200e9, 500e6, 0.01, curve, 0.05};
    Bar bar{law, {}};
    EXPECT_GT(bar.to(0.05), law.yield);
    break_beyond(law, bar.strain, bar.state);
    EXPECT_EQ(bar.state.broken, 0);
    bar.to(0.0501, 1);
    break_beyond(law, bar.strain, bar.state);
    EXPECT_EQ(bar.to(0.0502, 1), 0);
    EXPECT_EQ(bar.to(-0.01), 0);
    EXPECT_EQ(stored(law, bar.state), 0);
  }
}

}  // namespace
}  // namespace adit::sections::test::steel_law_test

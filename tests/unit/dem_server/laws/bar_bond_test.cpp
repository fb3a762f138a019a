// Requirements on the bond of bars.
#include "dem_server/laws/bar_bond.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace adit::dem::bar_bond_test {
namespace {

// Good bond in C30/37: 2.5 sqrt(38) MPa.
const BarBondLaw kLaw{200e9, 15.41e6, 1e-3, 2e-3, 10e-3, 0.4, 0.4};

struct Slider {
  BarBondLaw law = kLaw;
  BarBondState state{};
  double slip = 0, work = 0, lost = 0;

  void to(double goal, int steps = 1000) {
    const double from = slip;
    for (int i = 1; i <= steps; ++i) {
      const double next = from + (goal - from) * i / steps;
      const BarBondState now = slip_to(law, next, state).state;
      work += (state.stress + now.stress) / 2 * (next - slip);
      const double loss = (state.stress + now.stress) / 2 * (now.plastic - state.plastic);
      EXPECT_GE(loss, -1e-12);
      lost += loss;
      state = now;
      slip = next;
    }
  }
  double stored() const { return state.stress * state.stress / (2 * law.stiffness); }
};

// A bar that is pulled out goes through the curve of the fib Model Code.
TEST(BarBond, FollowsTheCurveOfTheModelCode) {
  Slider bar;
  for (const auto& [slip, share] : {std::pair{0.25e-3, std::pow(0.25, 0.4)},
                                    {0.5e-3, std::pow(0.5, 0.4)},
                                    {1e-3, 1.0},
                                    {2e-3, 1.0},
                                    {6e-3, 0.7},
                                    {10e-3, 0.4},
                                    {15e-3, 0.4}}) {
    bar.to(slip);
    EXPECT_NEAR(bar.state.stress, share * kLaw.strength, 1e-6 * kLaw.strength) << slip;
  }
}

// Where the bar was, friction is left on the way back and out again, until it comes to where it was.
TEST(BarBond, LeavesFrictionWhereTheBarWas) {
  Slider bar;
  bar.to(1e-3);
  bar.to(0.5e-3);
  EXPECT_NEAR(bar.state.stress, -0.4 * kLaw.strength, 1e-6 * kLaw.strength);
  bar.to(-0.9e-3);
  EXPECT_NEAR(bar.state.stress, -0.4 * kLaw.strength, 1e-6 * kLaw.strength);
  bar.to(-1.5e-3);
  EXPECT_NEAR(bar.state.stress, -kLaw.strength, 1e-6 * kLaw.strength);
}

// Any motion: the work is what is stored and what is lost, and nothing is ever gained.
TEST(BarBond, NeverCreatesEnergy) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> slips(-4e-3, 4e-3);
  Slider bar;
  for (int i = 0; i < 200; ++i) {
    bar.to(slips(random), 100);
    EXPECT_NEAR(bar.work, bar.stored() + bar.lost, 1e-10 * bar.work);
  }
}

}  // namespace
}  // namespace adit::dem::bar_bond_test

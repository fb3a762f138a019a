// Requirements on the shear stress within a column.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "simplified/column/joined_columns.hpp"
#include "tests/unit/simplified/column/deposits.hpp"

namespace adit::simplified::column::test::stress_test {
namespace {

// The waves of d'Alembert in an undamped uniform layer whose base begins to move with constant acceleration:
// the front and its reflections at surface and base change the stress by G a/V per time each.
double by_waves(const Layer& layer, double acceleration, double depth, double time) {
  const double slope = layer.modulus() * acceleration / layer.wave_velocity;
  double stress = 0, sign = 1;
  for (int n = 0; n < 100; ++n, sign = -sign)
    for (const double side : {-1.0, 1.0}) {
      const double way = (2 * n + 1) * layer.thickness + side * depth;
      stress -= side * sign * slope * std::max(0.0, time - way / layer.wave_velocity);
    }
  return stress;
}

// The modes sum up to the stress of the wave equation; forty of them to 1 % of the largest.
TEST(Stress, IsThatOfTheWavesInAUniformLayer) {
  constexpr double kDt = 1e-4, kAcceleration = 2;
  const Deposit deposit = uniform_deposit(0);
  for (const double depth : {4.0, 12.5, 22.0}) {
    JoinedColumns model(std::vector<Column>{{0, deposit, 40}}, true, kDt);
    const auto place = model.place(0, depth);
    double largest = 0, worst = 0;
    for (int n = 1; n <= 5000; ++n) {
      model.step(std::vector{kAcceleration});
      const double expected = by_waves(deposit.layers[0], kAcceleration, depth, n * kDt);
      largest = std::max(largest, std::abs(expected));
      worst = std::max(worst, std::abs(model.stress(place) - expected));
    }
    EXPECT_LT(worst, 0.01 * largest) << depth;
  }
}

// In layers, a depth carries all mass above it under constant acceleration, once oscillations have died away.
TEST(Stress, CarriesTheMassAbove) {
  const Deposit deposit = three_layers(0.2);
  JoinedColumns model(std::vector<Column>{{0, deposit, 40}}, true, 0.01);
  for (int n = 0; n < 6000; ++n) model.step(std::vector{2.0});
  EXPECT_NEAR(model.stress(model.place(0, 8)), 2.0 * 8 * 1600, 0.01 * 2 * 8 * 1600);
  EXPECT_NEAR(model.stress(model.place(0, 15)), 2.0 * (8 * 1600 + 7 * 1850), 0.01 * 2 * 25750);
  EXPECT_NEAR(model.stress(model.place(0, 30)), 2.0 * (8 * 1600 + 14 * 1850 + 8 * 2000), 0.01 * 2 * 54700);
}

}  // namespace
}  // namespace adit::simplified::column::test::stress_test

// Requirements on the pore pressure of loose sand under cycles of stress.
#include "simplified/column/pore_pressure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace adit::simplified::column::test::pore_pressure_test {
namespace {

constexpr double kResistance = 12e3, kExponent = 0.34;

double damage_of(const std::vector<double>& path) {
  PorePressure sand(kResistance, kExponent);
  for (const double stress : path) sand.follow(stress);
  return sand.damage();
}

double of_half_cycle(double amplitude) {
  return std::pow(amplitude / kResistance, 1 / kExponent) / 30;
}

// The resistance liquefies the sand in 15 cycles, other amplitudes in 15 (R/a)^(1/b), whatever the step:
// between the first and the last peak of whole cycles the damage is exactly their number over that.
TEST(PorePressure, LiquefiesInTheCyclesOfItsResistance) {
  for (const double amplitude : {0.7 * kResistance, kResistance, 1.3 * kResistance})
    for (const int steps : {4, 40, 400}) {
      PorePressure sand(kResistance, kExponent);
      const double cycles = 15 * std::pow(kResistance / amplitude, 1 / kExponent);
      for (int n = 1; n <= 10 * steps + steps / 4; ++n) {
        sand.follow(amplitude * std::sin(2 * std::numbers::pi * n / steps));
        if (n % steps != steps / 4) continue;
        EXPECT_NEAR(sand.damage(), (n / steps + 0.25) / cycles, 1e-12) << amplitude;
      }
    }
}

// At the resistance the pressure is that of De Alba et al. after each cycle, and 1 from the fifteenth on.
TEST(PorePressure, GrowsByTheLawOfDeAlba) {
  PorePressure sand(kResistance, kExponent);
  for (int n = 1; n <= 20; ++n) {
    sand.follow(kResistance);
    const double expected = 2 / std::numbers::pi * std::asin(std::pow((n - 0.75) / 15, 1 / 1.4));
    EXPECT_NEAR(sand.ratio(), n - 0.75 < 15 ? expected : 1, 1e-12) << n;
    sand.follow(-kResistance);
  }
}

// A loop within a half cycle does its own two half cycles and leaves the larger one as it was: rainflow
// counting.
TEST(PorePressure, ALoopWithinAHalfCycleDoesNotEndIt) {
  const double plain = damage_of({10e3, -10e3, 10e3});
  EXPECT_NEAR(plain, of_half_cycle(10e3) / 2 + 2 * of_half_cycle(10e3), 1e-15);
  EXPECT_NEAR(damage_of({10e3, 2e3, 6e3, -10e3, 10e3}) - plain, 2 * of_half_cycle(2e3), 1e-15);
  EXPECT_NEAR(damage_of({10e3, 2e3, 6e3, 4e3, 5e3, -10e3, 10e3}) - plain,
              2 * of_half_cycle(2e3) + 2 * of_half_cycle(0.5e3), 1e-15);
}

// A half cycle that exceeds all stresses so far goes on along the first path, on which a quarter cycle does
// half.
TEST(PorePressure, BeyondAllStressesSoFarTheFirstPathGoesOn) {
  EXPECT_NEAR(damage_of({10e3, -14e3}), of_half_cycle(10e3) + of_half_cycle(14e3) / 2, 1e-15);
  EXPECT_NEAR(damage_of({4e3, 1e3, 14e3}), of_half_cycle(14e3) / 2 + 2 * of_half_cycle(1.5e3), 1e-15);
}

// Nothing jumps, however the path is cut, and a path may begin in either direction.
TEST(PorePressure, ThePathAloneDecides) {
  const std::vector<double> path = {3e3, -8e3, 5e3, 1e3, 9e3, -9.5e3, 2e3};
  std::vector<double> cut, mirrored;
  double last = 0;
  for (const double stress : path) {
    for (int part = 1; part <= 7; ++part) cut.push_back(last + (stress - last) * part / 7);
    mirrored.push_back(-stress);
    last = stress;
  }
  EXPECT_NEAR(damage_of(cut), damage_of(path), 1e-15);
  EXPECT_EQ(damage_of(mirrored), damage_of(path));
}

}  // namespace
}  // namespace adit::simplified::column::test::pore_pressure_test

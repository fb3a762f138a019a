// Requirements on the exact transfer function.
#include "tests/support/column/wave_theory.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "tests/unit/simplified/column/deposits.hpp"

namespace adit::simplified::column::test::wave_theory_test {
namespace {

using Complex = std::complex<double>;
constexpr double kFirst = 4 * std::numbers::pi;  // of uniform_deposit [rad/s]

Complex wave_number(const Deposit& deposit, double frequency) {
  const Layer& layer = deposit.layers[0];
  return frequency / (layer.wave_velocity * std::sqrt(Complex(1, 2 * layer.damping)));
}

// A uniform deposit on rigid rock moves by cos(kz)/cos(kH).
TEST(WaveTheory, UniformDepositOnRigidRock) {
  const Deposit deposit = uniform_deposit();
  for (double f : {0.3, 1.0, 2.2, 3.0, 9.7})
    for (double z : {0.0, 10.0, 24.0, 25.0, 40.0}) {
      const Complex k = wave_number(deposit, f * kFirst);
      const Complex expected = std::cos(k * std::min(z, 25.0)) / std::cos(k * 25.0);
      EXPECT_NEAR(std::abs(wave_transfer(deposit, f * kFirst, z) - expected), 0, 1e-13 * std::abs(expected));
    }
}

// On elastic rock, against the outcrop, by cos(kz)/(cos(kH) + i alpha sin(kH)), alpha the
// ratio of impedances.
TEST(WaveTheory, UniformDepositOnElasticRock) {
  Deposit deposit = uniform_deposit();
  deposit.rock = kRock;
  const Complex alpha =
      deposit.layers[0].impedance() * std::sqrt(Complex(1, 0.1)) / deposit.rock->impedance();
  for (double f : {0.3, 1.0, 2.2, 3.0, 9.7})
    for (double z : {0.0, 10.0, 25.0}) {
      const Complex k = wave_number(deposit, f * kFirst);
      const Complex expected =
          std::cos(k * z) / (std::cos(k * 25.0) + Complex(0, 1) * alpha * std::sin(k * 25.0));
      EXPECT_NEAR(std::abs(wave_transfer(deposit, f * kFirst, z) - expected), 0, 1e-13 * std::abs(expected));
    }
}

// The amplification of a uniform deposit with 5 % damping peaks at 12.77, 4.22 and 2.49.
TEST(WaveTheory, PeaksOfTheUniformDeposit) {
  constexpr std::array kPeaks{12.77, 4.22, 2.49};
  for (std::size_t n = 0; n < 3; ++n) {
    double peak = 0;
    for (double f = 2.0 * n + 0.5; f < 2.0 * n + 1.5; f += 1e-4)
      peak = std::max(peak, std::abs(wave_transfer(uniform_deposit(), f * kFirst)));
    EXPECT_NEAR(peak, kPeaks[n], 0.005);
  }
}

// Layers of one material are one layer, and rock as soft as the soil reflects nothing: the surface
// moves as the outcrop.
TEST(WaveTheory, NoContrastNoReflection) {
  Deposit cut{{{4, 1900, 200, 0.05}, {13, 1900, 200, 0.05}, {8, 1900, 200, 0.05}}, {}};
  EXPECT_NEAR(std::abs(wave_transfer(cut, 20, 6) - wave_transfer(uniform_deposit(), 20, 6)), 0, 1e-13);
  Deposit half_space = uniform_deposit(0);
  half_space.rock = Rock{1900, 200};
  for (double f : {1.0, 20.0, 90.0}) EXPECT_NEAR(std::abs(wave_transfer(half_space, f)), 1, 1e-13);
}

}  // namespace
}  // namespace adit::simplified::column::test::wave_theory_test

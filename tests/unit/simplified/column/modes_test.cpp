// Requirements on the modes of a deposit.
#include "simplified/column/modes/modes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "simplified/column/modes/modal_column.hpp"
#include "tests/unit/simplified/column/deposits.hpp"
#include "tests/unit/simplified/column/finite_elements.hpp"

namespace adit::simplified::column::test::modes_test {
namespace {

constexpr double kPi = std::numbers::pi;

// A uniform deposit has the frequencies (2n - 1) V/4H.
TEST(Modes, UniformFrequencies) {
  const auto found = modes(uniform_deposit(), 40);
  for (std::size_t n = 0; n < found.size(); ++n)
    EXPECT_NEAR(found[n].frequency / (4 * kPi * (2 * static_cast<double>(n) + 1)), 1, 1e-14);
}

// Its effective masses are 81.06, 9.01, 3.24, 1.65 and 1.00 % and its participations at the surface 1.2732,
// -0.4244, 0.2546, -0.1819 and 0.1415, each digit.
TEST(Modes, UniformMassesAndParticipations) {
  constexpr std::array kMass{81.06, 9.01, 3.24, 1.65, 1.00};
  constexpr std::array kParticipation{1.2732, -0.4244, 0.2546, -0.1819, 0.1415};
  const Deposit deposit = uniform_deposit();
  const auto found = modes(deposit, 5);
  for (std::size_t n = 0; n < 5; ++n) {
    const double odd = 2 * static_cast<double>(n) + 1, sign = n % 2 ? -1 : 1;
    EXPECT_NEAR(100 * found[n].effective_mass / deposit.mass(), kMass[n], 0.005);
    EXPECT_NEAR(found[n].participation, kParticipation[n], 0.00005);
    EXPECT_NEAR(found[n].effective_mass / deposit.mass(), 8 / (kPi * kPi * odd * odd), 1e-13);
    EXPECT_NEAR(found[n].participation, sign * 4 / (kPi * odd), 1e-13);
  }
}

// A uniform deposit cut into thin layers keeps its modes: interfaces that are none change nothing.
TEST(Modes, InterfacesWithinAUniformDepositChangeNothing) {
  const Deposit whole = uniform_deposit();
  Deposit cut;
  for (double thickness : {0.3, 7.7, 1.0, 12.5, 3.5})
    cut.layers.push_back({thickness, 1900, 200, whole.layers[0].damping});
  const auto expected = modes(whole, 20), found = modes(cut, 20);
  for (std::size_t n = 0; n < 20; ++n) {
    EXPECT_NEAR(found[n].frequency / expected[n].frequency, 1, 1e-13);
    EXPECT_NEAR(found[n].participation, expected[n].participation, 1e-12);
    EXPECT_NEAR(shape(cut, found[n], 8.9), shape(whole, expected[n], 8.9), 1e-11);
  }
}

// Frequencies of three layers are those of an independent finite-element model, extrapolated from two meshes
// by its fourth order; participations and effective masses are those of the finer mesh.
TEST(Modes, ThreeLayersAgreeWithFiniteElements) {
  const Deposit deposit = three_layers();
  const FiniteElementModes coarse = finite_element_modes(deposit, 20),
                           fine = finite_element_modes(deposit, 40);
  const auto found = modes(deposit, 12);
  for (std::size_t n = 0; n < found.size(); ++n) {
    const auto i = static_cast<Eigen::Index>(n);
    const double expected = fine.frequencies[i] + (fine.frequencies[i] - coarse.frequencies[i]) / 15;
    EXPECT_NEAR(found[n].frequency / expected, 1, 1e-6);
    EXPECT_NEAR(found[n].participation, fine.participations[i], 1e-4);
    EXPECT_NEAR(found[n].effective_mass / deposit.mass(), fine.masses[i] / deposit.mass(), 1e-5);
  }
}

// No mode is missed: in deposits of random layers with contrasts up to 1:50, mode n crosses zero n - 1 times.
TEST(Modes, ModeNCrossesZeroNMinusOneTimes) {
  std::mt19937_64 random(7);
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, static_cast<double>(random() >> 11) * 0x1p-53);
  };
  for (int trial = 0; trial < 40; ++trial) {
    Deposit deposit;
    const auto layers = 1 + random() % 8;
    for (std::uint64_t i = 0; i < layers; ++i)
      deposit.layers.push_back({between(0.5, 30), between(1400, 2300), between(40, 2000), 0.05});
    const auto found = modes(deposit, 15);
    const double height = deposit.thickness();
    for (std::size_t n = 0; n < found.size(); ++n) {
      std::size_t crossings = 0;
      double last = 1;
      for (int k = 0; k < 20000; ++k) {
        const double now = shape(deposit, found[n], height * k / 20000);
        crossings += now * last < 0;
        last = now;
      }
      EXPECT_EQ(crossings, n);
    }
  }
}

// The effective masses of all modes make up the deposit's mass, and the shapes psi_n make up 1.
TEST(Modes, AllModesTogetherAreTheDeposit) {
  const Deposit deposit = three_layers();
  const ModalColumn column = modal_column(deposit, 4000);
  EXPECT_GT(column.rigid_mass, 0);
  EXPECT_LT(column.rigid_mass, 2e-4 * deposit.mass());
  for (double depth : {3.0, 11.0, 30.0}) {
    double sum = 0;
    for (double psi : shapes_at(column, depth)) sum += psi;
    EXPECT_NEAR(sum, 1, 1e-3);
  }
}

// A mode's damping is the layers' damping weighted with its strain energy: equal ratios give that ratio, and
// a quarter wave in the lossy lower half has (1/2 + 1/pi) of its energy there.
TEST(Modes, DampingIsWeightedWithStrainEnergy) {
  for (const Mode& mode : modes(three_layers(0.03), 10)) EXPECT_NEAR(mode.damping, 0.03, 1e-15);
  const Deposit halves{{{10, 1800, 150, 0}, {10, 1800, 150, 0.1}}, {}};
  EXPECT_NEAR(modes(halves, 1)[0].damping, 0.1 * (0.5 + 1 / kPi), 1e-13);
}

}  // namespace
}  // namespace adit::simplified::column::test::modes_test

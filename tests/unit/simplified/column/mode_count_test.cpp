// Requirements on the error of N modes.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/column/harmonic_response.hpp"
#include "tests/support/column/wave_theory.hpp"
#include "tests/unit/simplified/column/deposits.hpp"
#include "tests/unit/simplified/column/finite_elements.hpp"

namespace adit::simplified::column::test::mode_count_test {
namespace {

// The largest | |A_N| - |A| | over 0 < omega <= highest, as a fraction of the largest |A| there: A the
// amplification at the surface by wave theory, A_N that of the equivalent system with hysteretic damping.
// Eight samples lie within half the width of the sharpest peak, which is the first.
double amplification_error(const ModalColumn& column, double highest) {
  const Mode& first = column.modes.front();
  const auto samples = static_cast<std::size_t>(std::ceil(8 * highest / (first.frequency * first.damping)));
  double worst = 0, largest = 0;
  for (std::size_t i = 1; i <= samples; ++i) {
    const double frequency = highest * static_cast<double>(i) / static_cast<double>(samples);
    const double exact = std::abs(wave_transfer(column.deposit, frequency));
    worst = std::max(worst, std::abs(std::abs(modal_transfer(column, frequency)) - exact));
    largest = std::max(largest, exact);
  }
  return worst / largest;
}

struct Case {
  double band;        // in first frequencies
  std::size_t modes;  // N
  double percent;     // error against wave theory, of the largest amplification
};

// A uniform deposit with 5 % damping has the errors that theory gives, within 0.2 points.
TEST(ModeCount, ErrorsOfTheUniformDeposit) {
  const Deposit deposit = uniform_deposit();
  for (const Case& c : {Case{4, 2, 2.7}, {4, 3, 0.5}, {6, 3, 2.7}, {6, 4, 0.6}, {10, 5, 2.0}, {10, 8, 0.2}}) {
    const ModalColumn column = modal_column(deposit, c.modes);
    const double error = amplification_error(column, c.band * column.modes[0].frequency);
    EXPECT_NEAR(100 * error, c.percent, 0.2);
    RecordProperty("uniform_" + std::to_string(int(c.band)) + "f1_N" + std::to_string(c.modes),
                   std::to_string(100 * error));
  }
}

// The same study for three layers: the errors are those of the modes of an independent finite-element model,
// within 0.2 points, and two modes above the band suffice for 1 %.
TEST(ModeCount, ErrorsOfThreeLayers) {
  const Deposit deposit = three_layers();
  const FiniteElementModes elements = finite_element_modes(deposit, 30);
  const double first = elements.frequencies[0];
  for (double band : {4.0, 6.0, 10.0}) {
    const auto within = static_cast<std::size_t>((elements.frequencies.array() < band * first).count());
    for (std::size_t count = within; count <= within + 2; ++count) {
      double largest = 0, worst = 0;
      for (double f = 0.002 * first; f <= band * first; f += 0.002 * first) {
        std::complex<double> amplification = 1;
        for (Eigen::Index n = 0; n < static_cast<Eigen::Index>(count); ++n)
          amplification += elements.participations[n] * f * f /
                           (std::pow(elements.frequencies[n], 2) * std::complex<double>(1, 0.1) - f * f);
        const double exact = std::abs(wave_transfer(deposit, f));
        largest = std::max(largest, exact);
        worst = std::max(worst, std::abs(std::abs(amplification) - exact));
      }
      const double error = amplification_error(modal_column(deposit, count), band * first);
      EXPECT_NEAR(100 * error, 100 * worst / largest, 0.2);
      if (count == within + 2) {
        EXPECT_LT(error, 0.01);
      }
      RecordProperty("layers_" + std::to_string(int(band)) + "f1_N" + std::to_string(count),
                     std::to_string(100 * error));
    }
  }
}

// On elastic rock the equivalent system converges to wave theory: 60 modes are within 0.1 %.
TEST(ModeCount, ElasticRockConverges) {
  Deposit deposit = three_layers();
  deposit.rock = kRock;
  EXPECT_LT(amplification_error(modal_column(deposit, 60), 2 * std::numbers::pi * 12), 1e-3);
}

}  // namespace
}  // namespace adit::simplified::column::test::mode_count_test

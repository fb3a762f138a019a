// Requirements on the error of N modes.
#include "simplified/column/modes/mode_count.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "protocol/errors.hpp"
#include "simplified/column/modes/wave_theory.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/simplified/column/deposits.hpp"
#include "tests/unit/simplified/column/finite_elements.hpp"

namespace adit::simplified::column::test::mode_count_test {
namespace {

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
    const std::size_t within = modes_below(deposit, band * first);
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

// The number chosen reaches the stated error and one fewer does not, on rigid and on elastic rock, at the
// surface and below.
TEST(ModeCount, ChosenNumberIsTheSmallest) {
  for (bool elastic : {false, true})
    for (double depth : {0.0, 15.0})
      for (double error : {0.03, 0.01, 0.001}) {
        Deposit deposit = three_layers();
        if (elastic) deposit.rock = kRock;
        const double highest = 2 * std::numbers::pi * 12;
        const std::size_t count = modes_needed(deposit, highest, error, depth);
        EXPECT_LE(amplification_error(modal_column(deposit, count), highest, depth), error);
        ASSERT_GT(count, 1u);
        for (std::size_t fewer = 1; fewer < count; ++fewer)
          EXPECT_GT(amplification_error(modal_column(deposit, fewer), highest, depth), error);
      }
}

// On elastic rock the equivalent system converges to wave theory: 60 modes are within 0.1 %.
TEST(ModeCount, ElasticRockConverges) {
  Deposit deposit = three_layers();
  deposit.rock = kRock;
  EXPECT_LT(amplification_error(modal_column(deposit, 60), 2 * std::numbers::pi * 12), 1e-3);
}

// An error that no number of modes reaches, since the layers damp differently, is refused with the
// least that is reached.
TEST(ModeCount, UnreachableErrorIsRefused) {
  Deposit deposit = three_layers();
  deposit.layers[0].damping = 0.2;
  deposit.layers[2].damping = 0.01;
  adit::test::expect_refusal([&] { modes_needed(deposit, 2 * std::numbers::pi * 12, 1e-6); }, "",
                             "up to 12 Hz with 200 modes");
}

}  // namespace
}  // namespace adit::simplified::column::test::mode_count_test

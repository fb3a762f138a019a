// Requirements on a column's response over time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simplified/column/joined_columns.hpp"
#include "tests/support/column/harmonic_response.hpp"
#include "tests/support/column/oscillator_response.hpp"
#include "tests/unit/simplified/column/deposits.hpp"
#include "tests/unit/simplified/column/spectral.hpp"

namespace adit::simplified::column::test::response_test {
namespace {

double largest(const std::vector<double>& values) {
  double result = 0;
  for (double value : values) result = std::max(result, std::abs(value));
  return result;
}

// A step that is cut in four, with the motion on its straight lines, ends at the same place:
// the recursion is exact.
TEST(OscillatorResponse, IsExactForPiecewiseLinearMotion) {
  constexpr double kDt = 0.02;
  const ModalColumn column = modal_column(three_layers(), 10);
  const auto shapes = shapes_at(column, 0);
  OscillatorResponse coarse(column, kDt), fine(column, kDt / 4);
  double last = 0;
  for (int i = 1; i <= 500; ++i) {
    const double now = std::sin(0.37 * i) + std::cos(1.3 * i) - 1;
    coarse.step(now);
    for (int part = 1; part <= 4; ++part) fine.step(last + (now - last) * part / 4);
    last = now;
    ASSERT_NEAR(coarse.displacement(shapes), fine.displacement(shapes), 1e-12);
    ASSERT_NEAR(coarse.velocity(shapes), fine.velocity(shapes), 1e-11);
    ASSERT_NEAR(coarse.acceleration(shapes), fine.acceleration(shapes), 1e-9);
  }
}

// The answer over time is that by frequency, with the dashpots, to 1e-4 of the largest: at the surface and at
// the tunnel's depth.
TEST(OscillatorResponse, AgreesWithTheFrequencyDomain) {
  constexpr double kDt = 0.001;
  const ModalColumn column = modal_column(three_layers(), 6);
  const auto motion = pulse(kDt, 3);
  for (double depth : {0.0, 15.0}) {
    const auto expected = by_frequency(motion, kDt, [&](double frequency) {
      return modal_transfer(column, frequency, depth, Damping::kDashpots);
    });
    const auto shapes = shapes_at(column, depth);
    OscillatorResponse response(column, kDt);
    double worst = 0;
    for (std::size_t i = 1; i < motion.size(); ++i) {
      response.step(motion[i]);
      worst = std::max(worst, std::abs(response.acceleration(shapes) - expected[i]));
    }
    EXPECT_LT(worst, 1e-4 * largest(expected));
  }
}

// The calibrated dashpots give at every resonance what hysteretic damping gives.
TEST(OscillatorResponse, DashpotsAreCalibratedAtTheResonances) {
  const ModalColumn column = modal_column(three_layers(), 6);
  for (const Mode& mode : column.modes)
    EXPECT_NEAR(std::abs(oscillator_over_base(mode, mode.frequency, Damping::kDashpots) -
                         oscillator_over_base(mode, mode.frequency, Damping::kHysteretic)),
                0, 1e-12);
}

// A step of constant acceleration leaves at last the static answer: base force = mass times acceleration.
TEST(OscillatorResponse, BaseForceUnderConstantAcceleration) {
  const Deposit deposit = three_layers(0.2);
  OscillatorResponse response(modal_column(deposit, 4), 0.01);
  for (int i = 0; i < 6000; ++i) response.step(2.0);
  EXPECT_NEAR(response.base_force() / (2 * deposit.mass()), 1, 1e-10);
}

// A column on elastic rock over time is that by frequency, at second order in the time step.
TEST(ElasticRock, AgreesWithTheFrequencyDomain) {
  Deposit deposit = three_layers();
  deposit.rock = kRock;
  const std::vector<Column> columns{{0, deposit, 6}};
  std::vector<double> errors;
  for (double dt : {0.004, 0.002, 0.001}) {
    JoinedColumns model(columns, true, dt);
    const auto place = model.place(0, 0);
    const auto motion = pulse(dt, 3);
    const auto expected = by_frequency(motion, dt, [&](double frequency) {
      return modal_transfer(model.modal(0), frequency, 0, Damping::kDashpots);
    });
    double worst = 0;
    for (std::size_t i = 1; i < motion.size(); ++i) {
      model.step(std::span(&motion[i], 1));
      worst = std::max(worst, std::abs(model.acceleration(place) - expected[i]));
    }
    errors.push_back(worst / largest(expected));
  }
  EXPECT_LT(errors[2], 1e-3);
  EXPECT_NEAR(errors[0] / errors[1], 4, 0.3);
  EXPECT_NEAR(errors[1] / errors[2], 4, 0.3);
}

}  // namespace
}  // namespace adit::simplified::column::test::response_test

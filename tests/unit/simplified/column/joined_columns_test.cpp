// Requirements on columns joined along the tunnel.
#include "simplified/column/joined_columns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/support/column/oscillator_response.hpp"
#include "tests/support/column/recursion.hpp"
#include "tests/unit/simplified/column/deposits.hpp"

namespace adit::simplified::column::test::joined_columns_test {
namespace {

constexpr double kPi = std::numbers::pi;

double motion_at(double t) {
  return t < 3 ? std::sin(kPi * t / 3) * std::sin(11 * t) : 0;
}

std::vector<Column> row(const Deposit& deposit, std::size_t count, double length, std::size_t modes) {
  std::vector<Column> columns;
  for (std::size_t j = 0; j < count; ++j)
    columns.push_back({length * static_cast<double>(j) / static_cast<double>(count - 1), deposit, modes});
  return columns;
}

// A matrix that has no factor is refused, not solved: the second block is 1 - 2 * 2 = -3.
TEST(BlockTridiagonalFactor, RefusesWhatIsNotPositiveDefinite) {
  BlockTridiagonal matrix(std::array<std::size_t, 2>{1, 1});
  for (const std::size_t block : {0u, 1u}) matrix.add_diagonal(block, Eigen::MatrixXd::Ones(1, 1));
  matrix.add_upper(0, Eigen::MatrixXd::Constant(1, 1, 2));
  try {
    BlockTridiagonalFactor{matrix};
    ADD_FAILURE() << "solved";
  } catch (const std::logic_error& error) {
    EXPECT_STREQ(error.what(), "block 1 of the soil columns is not positive definite");
  }
}

// Columns that are not joined are single columns, each with its own layers, at second order in the time step.
TEST(JoinedColumns, UnjoinedAreSingleColumns) {
  const std::vector<Column> columns{{0, uniform_deposit(), 3}, {20, three_layers(), 4}};
  std::vector<double> errors;
  for (double dt : {0.004, 0.002}) {
    JoinedColumns model(columns, false, dt);
    OscillatorResponse first(model.modal(0), dt), second(model.modal(1), dt);
    const auto shapes_first = shapes_at(model.modal(0), 4), shapes_second = shapes_at(model.modal(1), 4);
    const auto place_first = model.place(0, 4), place_second = model.place(1, 4);
    double worst = 0;
    for (double t = dt; t < 6; t += dt) {
      model.step(std::vector{motion_at(t), -2 * motion_at(t)});
      first.step(motion_at(t));
      second.step(-2 * motion_at(t));
      worst = std::max({worst, std::abs(model.acceleration(place_first) - first.acceleration(shapes_first)),
                        std::abs(model.acceleration(place_second) - second.acceleration(shapes_second))});
    }
    errors.push_back(worst);
  }
  EXPECT_LT(errors[1], 0.02);
  EXPECT_NEAR(errors[0] / errors[1], 4, 0.3);
}

// Equal columns under one motion move as one column does: the springs feel no difference.
TEST(JoinedColumns, EqualColumnsUnderOneMotionMoveAsOne) {
  constexpr double kDt = 0.005;
  for (bool elastic : {false, true}) {
    Deposit deposit = three_layers();
    if (elastic) deposit.rock = kRock;
    JoinedColumns single(row(deposit, 2, 10, 5), false, kDt), joined(row(deposit, 7, 120, 5), true, kDt);
    const auto alone = single.place(0, 6), end = joined.place(0, 6), inside = joined.place(3, 6);
    for (double t = kDt; t < 4; t += kDt) {
      single.step(std::vector(2, motion_at(t)));
      joined.step(std::vector(7, motion_at(t)));
      ASSERT_NEAR(joined.displacement(end), single.displacement(alone), 1e-12);
      ASSERT_NEAR(joined.velocity(inside), single.velocity(alone), 1e-11);
      ASSERT_NEAR(joined.acceleration(inside), single.acceleration(alone), 1e-9);
    }
  }
}

// A wave cos(kx) along the tunnel stiffens oscillator n to omega_n^2 + chi V^2 k^2 (exact for the continuum):
// the joined columns reach that at second order in their spacing.
TEST(JoinedColumns, ConvergeToTheContinuumAtSecondOrder) {
  constexpr double kLength = 200, kDt = 0.0005, kRatio = 1.8;
  constexpr std::size_t kModes = 2;
  const double k = 2 * kPi / kLength, V = 200;
  const auto free = modes(uniform_deposit(0), kModes);
  std::vector<double> errors;
  for (std::size_t spaces : {10u, 20u, 40u}) {
    const auto columns = row(with_ratio(uniform_deposit(0), kRatio), spaces + 1, kLength, kModes);
    JoinedColumns model(columns, true, kDt);
    const auto place = model.place(0, 0);
    // (q, q', u_g, v_g): q'' + (omega^2 + chi V^2 k^2) q = -a - chi V^2 k^2 u_g
    std::vector<Recursion> exact;
    std::vector<Eigen::VectorXd> state(kModes, Eigen::VectorXd::Zero(4));
    for (const Mode& mode : free) {
      const double lateral = kRatio * V * V * k * k;
      Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
      A(0, 1) = A(2, 3) = 1;
      A(1, 0) = -mode.frequency * mode.frequency - lateral;
      A(1, 2) = -lateral;
      exact.push_back(piecewise_linear(A, Eigen::Vector4d(0, -1, 0, 1), kDt));
    }
    double worst = 0, last = 0;
    std::vector<double> motion(columns.size());
    for (int i = 1; i <= 4000; ++i) {
      const double now = motion_at(i * kDt);
      for (std::size_t j = 0; j < columns.size(); ++j) motion[j] = now * std::cos(k * columns[j].chainage);
      model.step(motion);
      double expected = 0;
      for (std::size_t n = 0; n < kModes; ++n) {
        state[n] = exact[n].transition * state[n] + exact[n].from_start * last + exact[n].from_end * now;
        expected += free[n].participation * state[n][0];
      }
      expected += state[0][2];
      last = now;
      worst = std::max(worst, std::abs(model.displacement(place) - expected));
    }
    errors.push_back(worst);
  }
  EXPECT_NEAR(errors[0] / errors[1], 4, 0.3);
  EXPECT_NEAR(errors[1] / errors[2], 4, 0.3);
}

// A base that is slowly bent to cos(kx) bends the surface by 1/cosh(sqrt(chi) k H) of it: the ground between
// cannot follow short waves.
TEST(JoinedColumns, SlowBendingOfTheBaseDecaysUpwards) {
  constexpr double kLength = 100, kDt = 0.02, kRatio = 2.5, kRise = 40;
  const double k = kPi / kLength;
  const auto columns = row(with_ratio(uniform_deposit(), kRatio), 41, kLength, 12);
  JoinedColumns model(columns, true, kDt);
  const auto surface = model.place(0, 0), base = model.place(0, 25);
  std::vector<double> motion(columns.size());
  const double rate = 2 * kPi / kRise;
  for (int i = 1; i <= static_cast<int>(kRise / kDt); ++i) {
    const double now = std::sin(rate * i * kDt);
    for (std::size_t j = 0; j < columns.size(); ++j) motion[j] = now * std::cos(k * columns[j].chainage);
    model.step(motion);
  }
  EXPECT_NEAR(model.displacement(surface) / model.displacement(base),
              1 / std::cosh(std::sqrt(kRatio) * k * 25), 1e-3);
}

// Each base moves by the double integral of its own motion, exact for straight lines between samples.
TEST(JoinedColumns, BasesFollowTheirOwnMotions) {
  constexpr double kDt = 0.01;
  JoinedColumns model(row(uniform_deposit(), 2, 30, 2), true, kDt);
  const auto first = model.place(0, 25), second = model.place(1, 99);
  for (int i = 1; i <= 300; ++i) model.step(std::vector{i * kDt, -2 * i * kDt});  // a = t and -2 t
  EXPECT_NEAR(model.displacement(first), 27.0 / 6, 1e-11);
  EXPECT_NEAR(model.velocity(second), -9, 1e-11);
  EXPECT_NEAR(model.acceleration(second), -6, 1e-12);
}

}  // namespace
}  // namespace adit::simplified::column::test::joined_columns_test

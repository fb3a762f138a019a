// Requirements on the chain of masses and springs: the same system as the oscillators.
#include "simplified/column/response/chain.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "simplified/column/response/chain_response.hpp"
#include "simplified/column/response/oscillator_response.hpp"
#include "tests/unit/simplified/column/deposits.hpp"

namespace adit::simplified::column::test::chain_test {
namespace {

Deposit unequally_damped() {
  Deposit deposit = three_layers();
  deposit.layers[0].damping = 0.12;
  deposit.layers[2].damping = 0.02;
  return deposit;
}

// Masses and springs are positive, and the masses are those of the oscillators together.
TEST(Chain, IsOfPositiveMassesAndSprings) {
  for (const Deposit& deposit : {uniform_deposit(), three_layers()})
    for (std::size_t count : {1u, 2u, 5u, 20u}) {
      const Chain chain = equivalent_chain(modal_column(deposit, count));
      EXPECT_GT(chain.masses.minCoeff(), 0);
      EXPECT_GT(chain.springs.minCoeff(), 0);
      EXPECT_NEAR((chain.masses.sum() + chain.rigid_mass) / deposit.mass(), 1, 1e-13);
    }
}

// Its stiffness is that of springs in a row, and equal damping ratios make it 1 + 2 i xi on each spring.
TEST(Chain, HystereticLossIsProportionalForEqualDamping) {
  const Chain chain = equivalent_chain(modal_column(three_layers(), 6));
  EXPECT_LT((chain.loss - 0.1 * chain.stiffness).norm(), 1e-11 * chain.stiffness.norm());
}

// Force at the base and motion at any depth equal the oscillators' to 1e-10 at every frequency.
TEST(Chain, TransferFunctionsAreTheOscillators) {
  for (const Deposit& deposit : {uniform_deposit(), three_layers(), unequally_damped()})
    for (std::size_t count : {1u, 3u, 8u, 15u}) {
      const ModalColumn column = modal_column(deposit, count);
      const Chain chain = equivalent_chain(column);
      for (double f = 0.05; f < 12; f += 0.05) {
        const double frequency = f * column.modes[0].frequency;
        const auto force = base_stiffness(column, frequency);
        EXPECT_LT(std::abs(base_stiffness(chain, frequency) - force),
                  1e-10 * frequency * frequency * deposit.mass());
        for (double depth : {0.0, 12.0}) {
          const auto motion = modal_transfer(column, frequency, depth);
          EXPECT_LT(std::abs(base_transfer(chain, frequency, shapes_at(column, depth)) - motion),
                    1e-10 * (1 + std::abs(motion)));
        }
      }
    }
}

// Over time, with dashpots, both give the same motion and force to 1e-10 of the largest.
TEST(Chain, ResponsesOverTimeAreTheOscillators) {
  for (const Deposit& deposit : {uniform_deposit(), unequally_damped()}) {
    constexpr double kDt = 0.005;
    const ModalColumn column = modal_column(deposit, 8);
    OscillatorResponse oscillators(column, kDt);
    ChainResponse chain(equivalent_chain(column), kDt);
    const auto shapes = shapes_at(column, 5);
    double u = 0, v = 0, a = 0, f = 0, worst_u = 0, worst_v = 0, worst_a = 0, worst_f = 0;
    const auto compare = [](double one, double other, double& largest, double& worst) {
      largest = std::max(largest, std::abs(one));
      worst = std::max(worst, std::abs(one - other));
    };
    for (int i = 1; i <= 4000; ++i) {
      const double t = i * kDt, motion = i <= 2000 ? std::sin(9 * t) * std::sin(31 * t) : 0;
      oscillators.step(motion);
      chain.step(motion);
      compare(oscillators.displacement(shapes), chain.displacement(shapes), u, worst_u);
      compare(oscillators.velocity(shapes), chain.velocity(shapes), v, worst_v);
      compare(oscillators.acceleration(shapes), chain.acceleration(shapes), a, worst_a);
      compare(oscillators.base_force(), chain.base_force(), f, worst_f);
    }
    EXPECT_LT(worst_u, 1e-10 * u);
    EXPECT_LT(worst_v, 1e-10 * v);
    EXPECT_LT(worst_a, 1e-10 * a);
    EXPECT_LT(worst_f, 1e-10 * f);
    EXPECT_GT(u, 1e-3);
  }
}

}  // namespace
}  // namespace adit::simplified::column::test::chain_test

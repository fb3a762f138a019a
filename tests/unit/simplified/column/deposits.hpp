// Deposits that the tests share.
#pragma once

#include "simplified/column/modes/deposit.hpp"

namespace adit::simplified::column::test {

// First frequency V/4H = 2 Hz.
inline Deposit uniform_deposit(double damping = 0.05) {
  return {{{25, 1900, 200, damping}}, {}};
}

// Mud, sand and stiff clay.
inline Deposit three_layers(double damping = 0.05) {
  return {{{8, 1600, 110, damping}, {14, 1850, 220, damping}, {18, 2000, 380, damping}}, {}};
}

inline Deposit with_ratio(Deposit deposit, double modulus_ratio) {
  for (Layer& layer : deposit.layers) layer.modulus_ratio = modulus_ratio;
  if (deposit.rock) deposit.rock->modulus_ratio = modulus_ratio;
  return deposit;
}

inline const Rock kRock{2400, 1200};

}  // namespace adit::simplified::column::test

// The exact response of a layered deposit to a harmonic motion exp(i omega t), by 1-D wave theory.
#pragma once

#include <complex>

#include "simplified/column/modes/deposit.hpp"

namespace adit::simplified::column::test {

// Displacement at depth z divided by the given motion, which is that of the base or of the rock's outcrop
// (deposit.hpp). Every layer has the hysteretic modulus G (1 + 2 i xi). At the rock and below, the
// displacement is that of the base. For a uniform deposit on rigid rock the value at the surface is
// 1/cos(omega H / (V sqrt(1 + 2 i xi))). `frequency` is circular, > 0 [rad/s].
std::complex<double> wave_transfer(const Deposit& deposit, double frequency, double depth = 0);

}  // namespace adit::simplified::column::test

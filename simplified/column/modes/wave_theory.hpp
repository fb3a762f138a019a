// The exact answer of a layered deposit to a harmonic motion exp(i omega t), from 1-D wave theory.
#pragma once

#include <complex>

#include "simplified/column/modes/deposit.hpp"

namespace adit::simplified::column {

// Displacement at depth z over the given motion (deposit.hpp: of the base, or of the rock's outcrop), with
// the hysteretic modulus G (1 + 2 i xi) in every layer. At the rock and below it is the base's motion. A
// uniform deposit on rigid rock has 1/cos(omega H / (V sqrt(1 + 2 i xi))) at the surface. frequency:
// circular, > 0 [rad/s].
std::complex<double> wave_transfer(const Deposit& deposit, double frequency, double depth = 0);

}  // namespace adit::simplified::column

// The response of the modal-equivalent system of a deposit (modal_column.hpp) to a harmonic motion exp(i
// omega t).
#pragma once

#include <complex>

#include "simplified/column/modes/modal_column.hpp"

namespace adit::simplified::column::test {

enum class Damping { kHysteretic, kDashpots };

// q_n / u_b for a harmonic motion of the base, exp(i omega t): omega^2 / (omega_n^2 (1 + 2 i xi_n) -
// omega^2), or omega^2 / (omega_n^2 + 2 i xi_n omega_n omega - omega^2) with the dashpot. `frequency` is
// circular, > 0 [rad/s].
std::complex<double> oscillator_over_base(const Mode& mode, double frequency,
                                          Damping damping = Damping::kHysteretic);

// Force per area that moves the base, divided by its displacement [Pa/m]:
// -omega^2 (m_rigid + sum M_n (1 + q_n / u_b)).
std::complex<double> base_stiffness(const ModalColumn& column, double frequency,
                                    Damping damping = Damping::kHysteretic);

// The displacement of the base, divided by the given one: 1 on rigid rock; on elastic rock that of a deposit
// with this `base_stiffness`.
std::complex<double> base_over_given(const Deposit& deposit, double frequency,
                                     std::complex<double> base_stiffness);

// The same as wave_transfer (wave_theory.hpp), for the equivalent system.
std::complex<double> modal_transfer(const ModalColumn& column, double frequency, double depth = 0,
                                    Damping damping = Damping::kHysteretic);

}  // namespace adit::simplified::column::test

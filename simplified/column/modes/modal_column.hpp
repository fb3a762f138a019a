// The modal-equivalent system of a deposit: N oscillators side by side on the deposit's base, and the mass
// that they leave, fixed to the base. Mode n is the oscillator
//     M_n (q'' + u_b'') + c_n q' + K_n q = 0,   K_n = M_n omega_n^2,
// hysteretic in frequency, K_n (1 + 2 i xi_n), and with a dashpot in time, c_n = 2 xi_n K_n / omega_n, which
// dissipates the same at its resonance. The deposit moves by
//     u(z, t) = u_b(t) + sum_n psi_n(z) q_n(t),   psi_n = Gamma_n phi_n,
// and pulls at its base as the oscillators do. With all modes this is exact for layers of one damping
// ratio (different ratios couple the modes a little, which is left out); N modes keep the frequencies, the
// damping and the mass and lose only the dynamics of the modes above.
// Rock: a rigid one prescribes u_b; an elastic one gives the base the force rho_r V_r (u_out' - u_b') per
// area, which is the radiation of the half-space.
#pragma once

#include <complex>
#include <vector>

#include "simplified/column/modes/modes.hpp"

namespace adit::simplified::column {

struct ModalColumn {
  Deposit deposit;
  std::vector<Mode> modes;
  double rigid_mass;  // per area [kg/m^2]
};

enum class Damping { kHysteretic, kDashpots };

// The deposit has been checked; count >= 1.
ModalColumn modal_column(const Deposit& deposit, std::size_t count);

// psi_n at depth z [m], one value a mode; zeros at the rock and below.
std::vector<double> shapes_at(const ModalColumn& column, double depth);

// q_n / u_b for a harmonic motion of the base, exp(i omega t): omega^2 / (omega_n^2 (1 + 2 i xi_n) -
// omega^2), or with the dashpot omega^2 / (omega_n^2 + 2 i xi_n omega_n omega - omega^2). frequency:
// circular, > 0 [rad/s].
std::complex<double> oscillator_over_base(const Mode& mode, double frequency,
                                          Damping damping = Damping::kHysteretic);

// Force per area that moves the base, over the base's displacement [Pa/m]:
// -omega^2 (m_rigid + sum M_n (1 + q_n / u_b)).
std::complex<double> base_stiffness(const ModalColumn& column, double frequency,
                                    Damping damping = Damping::kHysteretic);

// The base's displacement over the given one: 1 on rigid rock; on elastic rock that of a deposit whose base
// resists by `base_stiffness`.
std::complex<double> base_over_given(const Deposit& deposit, double frequency,
                                     std::complex<double> base_stiffness);

// As wave_transfer (wave_theory.hpp), of the equivalent system.
std::complex<double> modal_transfer(const ModalColumn& column, double frequency, double depth = 0,
                                    Damping damping = Damping::kHysteretic);

}  // namespace adit::simplified::column

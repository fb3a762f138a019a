// The modal-equivalent system of a deposit: N oscillators side by side on the base of the deposit, and the
// remaining mass, which is fixed to the base. Mode n is the oscillator
//     M_n (q'' + u_b'') + c_n q' + K_n q = 0,   K_n = M_n omega_n^2,
// hysteretic in frequency, K_n (1 + 2 i xi_n), and with a dashpot in time, c_n = 2 xi_n K_n / omega_n, which
// dissipates the same at its resonance. The deposit moves by
//     u(z, t) = u_b(t) + sum_n psi_n(z) q_n(t),   psi_n = Gamma_n phi_n,
// and acts on its base with the forces of the oscillators. With all modes this is exact if all layers have
// the same damping ratio; different ratios couple the modes slightly, which is neglected. N modes have the
// right frequencies, damping and total mass, and miss only the dynamics of the higher modes. Rigid rock
// prescribes u_b. Elastic rock acts on the base with the force rho_r V_r (u_out' - u_b') per area, which
// includes the radiation into the half-space.
#pragma once

#include <vector>

#include "simplified/column/modes/modes.hpp"

namespace adit::simplified::column {

struct ModalColumn {
  Deposit deposit;
  std::vector<Mode> modes;
  double rigid_mass;  // per area [kg/m^2]
};

// The deposit must have been checked; count >= 1.
ModalColumn modal_column(const Deposit& deposit, std::size_t count);

// psi_n at depth z [m], one value for each mode; zero at the rock and below.
std::vector<double> shapes_at(const ModalColumn& column, double depth);

// G psi_n' at depth z within the deposit [Pa/m]: the shear stress is their sum over q_n. That of the
// dashpots, which is 2 xi_n of it at the resonance of mode n and a quarter of a cycle away, is left out.
std::vector<double> stresses_at(const ModalColumn& column, double depth);

}  // namespace adit::simplified::column

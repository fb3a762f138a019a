#include "tests/support/column/harmonic_response.hpp"

namespace adit::simplified::column::test {

using Complex = std::complex<double>;

Complex oscillator_over_base(const Mode& mode, double frequency, Damping damping) {
  const double of_loss = damping == Damping::kHysteretic ? mode.frequency : frequency;
  const Complex resistance(mode.frequency * mode.frequency - frequency * frequency,
                           2 * mode.damping * mode.frequency * of_loss);
  return frequency * frequency / resistance;
}

Complex base_stiffness(const ModalColumn& column, double frequency, Damping damping) {
  Complex mass = column.rigid_mass;
  for (const Mode& mode : column.modes)
    mass += mode.effective_mass * (1.0 + oscillator_over_base(mode, frequency, damping));
  return -frequency * frequency * mass;
}

// From the equilibrium of the base: the force of the rock, i omega rho_r V_r (u_out - u_b), equals
// base_stiffness * u_b.
Complex base_over_given(const Deposit& deposit, double frequency, Complex base_stiffness) {
  if (!deposit.rock) return 1;
  const Complex dashpot(0, frequency * deposit.rock->impedance());
  return dashpot / (dashpot + base_stiffness);
}

Complex modal_transfer(const ModalColumn& column, double frequency, double depth, Damping damping) {
  Complex over_base = 1;
  for (const Mode& mode : column.modes)
    over_base += mode.participation * shape(column.deposit, mode, depth) *
                 oscillator_over_base(mode, frequency, damping);
  return over_base * base_over_given(column.deposit, frequency, base_stiffness(column, frequency, damping));
}

}  // namespace adit::simplified::column::test

// Modes of a layered deposit on a fixed base, exact by 1-D wave theory:
//     (G phi')' + rho omega^2 phi = 0,   G phi' = 0 at the surface,   phi = 0 at the rock.
#pragma once

#include <complex>
#include <vector>

#include "simplified/column/modes/deposit.hpp"

namespace adit::simplified::column {

// A mode, normalized to phi = 1 at the surface.
struct Mode {
  double frequency;       // circular frequency omega_n [rad/s]
  double damping;         // xi_n: mean of the layers' ratios, weighted with the mode's strain energy in each
  double participation;   // Gamma_n = int rho phi / int rho phi^2
  double effective_mass;  // M_n = (int rho phi)^2 / int rho phi^2, per area [kg/m^2]
  // phi = Re(amplitude * exp(i omega s / V)) in each layer, s the distance below the layer's top.
  std::vector<std::complex<double>> amplitudes;
};

// The first `count` modes in the order of their frequencies. None is missed, because they are found by the
// phase of the wave at the rock, which increases with frequency and passes an odd multiple of pi/2 at every
// mode. The deposit must have been checked.
std::vector<Mode> modes(const Deposit& deposit, std::size_t count);

// phi at depth z [m]; 0 at the rock and below.
double shape(const Deposit& deposit, const Mode& mode, double depth);

// The stress G phi' of the mode at depth z [Pa/m], within the deposit.
double stress(const Deposit& deposit, const Mode& mode, double depth);

}  // namespace adit::simplified::column

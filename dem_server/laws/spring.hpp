// Energy of a linear spring per mode: extension, shear, rotation.
#pragma once

namespace adit::dem {

// F^2 / 2k [J]; nothing where there is no stiffness.
inline double spring_energy(double force, double stiffness) {
  return stiffness > 0 ? 0.5 * force * force / stiffness : 0.0;
}

// What a spring of force F gives up where it breaks, in the leap-frog scheme's own form F(n-1) F(n) / 2k with
// F(n-1) = F - k motion, so that the energy ledger closes to rounding [J]. `motion` is that of the last step.
inline double released_energy(double force, double stiffness, double motion) {
  return stiffness > 0 ? 0.5 * force * (force / stiffness - motion) : 0.0;
}

}  // namespace adit::dem

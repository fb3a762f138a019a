// Kinetic energy of the assembly in the form that the leap-frog scheme keeps, weighted [J].
//
// With kinetic energy T(n) = 1/2 sum m v(n-1/2) v(n+1/2), T(n) - T(n-1) is the trapezoidal work of all
// forces, dt v(n-1/2) (f(n-1) + f(n)) / 2, without any remainder; for linear springs the strain energy loses
// just that.
#pragma once

#include <vector>

#include "dem_server/particles/particles.hpp"
#include "protocol/state/archive.hpp"

namespace adit::dem {

// Velocities half a step ago.
struct Velocities {
  std::vector<double> x, y, spin;

  void exchange(state::Archive& archive) {
    archive("velocities_before_x", std::span(x));
    archive("velocities_before_y", std::span(y));
    archive("velocities_before_spin", std::span(spin));
  }
};

// Overwrites `velocities` with the particles' present ones (no allocation after the first time).
void remember(const Particles& particles, Velocities& velocities);

// 1/2 sum m v_before v + J w_before w. For the first step, from rest, v(-1/2) = -v(1/2): pass `start` true,
// and add PrescribedMotions::kinetic_energy(), because v(-1/2) is 0 where a motion is prescribed.
double kinetic_energy(const Particles& particles, const Velocities& before, bool start);

}  // namespace adit::dem

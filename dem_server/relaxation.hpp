// How far the particles are from rest while they relax (wire.proto, message Relaxation).
#pragma once

#include "dem_server/assembly.hpp"
#include "dem_server/energy.hpp"

namespace adit::dem {

// Of a step, weighted.
struct Unrest {
  double unbalanced_force =
      0;  // sum over the particles of |mass · change of velocity| / duration of the kick [N]
  double internal_force = 0;  // sum over the bonds of |force| [N]
};

// Of the present velocities and spins, weighted [J].
double kinetic_energy(const Particles& particles);

class Relaxation {
 public:
  explicit Relaxation(const Assembly& at_rest) { remember(at_rest.particles, before_); }

  // Of the step whose velocities were just corrected. A kick changed them for `kick` seconds since the last
  // call, or since all were 0.
  Unrest measure(const Assembly& assembly, double kick);
  // All velocities became 0.
  void stopped(const Assembly& assembly) { remember(assembly.particles, before_); }

 private:
  Velocities before_;  // a step before
};

}  // namespace adit::dem

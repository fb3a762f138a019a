// How far the particles are from rest while they relax (wire.proto, message Relaxation).
#pragma once

#include <span>
#include <vector>

#include "dem_server/engines/answers.hpp"
#include "dem_server/model/model.hpp"
#include "dem_server/particles/energy.hpp"
#include "dem_server/particles/particles.hpp"
#include "protocol/state/archive.hpp"

namespace adit::dem {

// Kinetic energy of the present velocities and spins, with the masses that statics move, weighted [J].
double kinetic_energy(const Particles& particles);

class Relaxation {
 public:
  explicit Relaxation(const Particles& at_rest) { remember(at_rest, before_); }

  // The unbalanced forces of the step whose velocities were just corrected: mass · change of velocity /
  // duration of the kick [N], weighted. A kick changed them for `kick` seconds since the last call, or since
  // all were 0, damped by this share. Internal forces and elements are left to the caller.
  Unrest measure(const Particles& particles, double kick, double local_damping,
                 std::span<const EdgeDashpot> edges);
  // All velocities were slowed, or stopped.
  void slowed(const Particles& particles) { remember(particles, before_); }

  void exchange(state::Archive& archive) { before_.exchange(archive); }

 private:
  Velocities before_;                      // a step before
  std::vector<double> force_x_, force_y_;  // scratch
};

}  // namespace adit::dem

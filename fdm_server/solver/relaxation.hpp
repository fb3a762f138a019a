// How far the grid is from rest while it relaxes (wire.proto, message Relaxation).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/solver/continuum.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

// How far a step is from rest, weighted.
struct Unrest {
  double unbalanced_force;  // sum over the points of |mass · change of velocity| / duration of the kick [N]
  double internal_force;    // sum over the zones of |stress| · √area, |stress| its Frobenius norm [N]
  double largest = 0;       // unbalanced force of a point [N], and its number
  std::size_t at = 0;
};

// The kinetic energy of the present velocities and rotations, weighted [J].
double kinetic_energy(const Continuum& continuum);

class Relaxation {
 public:
  Relaxation(const Grid& grid, std::span<const double> zone_weights);

  // Measures the step whose velocities were just corrected. A kick changed them for `kick` seconds since the
  // last call, or since all were 0, damped by this share of the unbalanced forces.
  Unrest measure(Continuum& continuum, double kick, double local_damping = 0);
  // The sum of the unbalanced forces measured last, of those of these points that bear on no dashpots [N].
  Vector net(const Continuum& continuum, protocol::IndexRange points) const;
  // All velocities were multiplied by this factor.
  void slowed(double factor);
  void exchange(state::Archive& archive) {
    archive("relaxation_vx", std::span(vx_));
    archive("relaxation_vy", std::span(vy_));
    archive("relaxation_fx", std::span(fx_));
    archive("relaxation_fy", std::span(fy_));
  }

 private:
  std::vector<double> vx_, vy_;  // a step before
  std::vector<double> fx_, fy_;  // unbalanced, as measured last [N]
  std::vector<double> factor_;   // weight · √area of each zone [m]
};

}  // namespace adit::fdm

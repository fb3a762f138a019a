#include "dem_server/engines/relaxation.hpp"

#include <cmath>

#include "protocol/participant/local_damping.hpp"

namespace adit::dem {

double kinetic_energy(const Particles& p) {
  double twice = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p.is_there(i))
      twice += (p.vx[i] * p.vx[i] + p.vy[i] * p.vy[i]) / p.inverse_mass[i] +
               p.spin[i] * p.spin[i] / p.inverse_inertia[i];
  return twice / 2;
}

Unrest Relaxation::measure(const Particles& p, double kick, double local_damping,
                           std::span<const EdgeDashpot> edges) {
  Unrest unrest;
  unrest.particles = p.size();
  const auto force = [&](std::size_t i, double after, double before) {
    return protocol::undamped_change(after - before, before, local_damping) / (p.inverse_mass[i] * kick);
  };
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!p.is_there(i)) continue;
    const double x = force(i, p.vx[i], before_.x[i]), y = force(i, p.vy[i], before_.y[i]);
    const double size = std::hypot(x, y);
    unrest.unbalanced_force += size;
    unrest.net_x += x;
    unrest.net_y += y;
    if (size > unrest.largest) {
      unrest.largest = size;
      unrest.x = p.x[i];
      unrest.y = p.y[i];
    }
  }
  for (const EdgeDashpot& edge : edges) {  // which statics hold: their velocities are 0
    unrest.drag_x += edge.damping_x * p.weight[edge.disc];
    unrest.drag_y += edge.damping_y * p.weight[edge.disc];
  }
  remember(p, before_);
  return unrest;
}

}  // namespace adit::dem

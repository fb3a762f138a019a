#include "dem_server/particles/energy.hpp"

namespace adit::dem {

void remember(const Particles& p, Velocities& velocities) {
  velocities.x = p.vx;
  velocities.y = p.vy;
  velocities.spin = p.spin;
}

double kinetic_energy(const Particles& p, const Velocities& before, bool start) {
  double twice = 0;
  if (start)
    for (std::size_t i = 0; i < p.size(); ++i)
      twice -= p.mass[i] * (p.vx[i] * p.vx[i] + p.vy[i] * p.vy[i]) + p.inertia[i] * p.spin[i] * p.spin[i];
  else
    for (std::size_t i = 0; i < p.size(); ++i)
      twice += p.mass[i] * (before.x[i] * p.vx[i] + before.y[i] * p.vy[i]) +
               p.inertia[i] * before.spin[i] * p.spin[i];
  return twice / 2;
}

}  // namespace adit::dem

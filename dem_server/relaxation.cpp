#include "dem_server/relaxation.hpp"

#include <cmath>

namespace adit::dem {

double kinetic_energy(const Particles& p) {
  double twice = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    twice += p.mass[i] * (p.vx[i] * p.vx[i] + p.vy[i] * p.vy[i]) + p.inertia[i] * p.spin[i] * p.spin[i];
  return twice / 2;
}

Unrest Relaxation::measure(const Assembly& assembly, double kick) {
  const Particles& p = assembly.particles;
  const Bonds& b = assembly.bonds;
  Unrest unrest;
  for (std::size_t i = 0; i < p.size(); ++i)
    unrest.unbalanced_force += p.mass[i] * std::hypot(p.vx[i] - before_.x[i], p.vy[i] - before_.y[i]) / kick;
  for (std::size_t k = 0; k < b.size(); ++k)
    unrest.internal_force += b.weight[k] * std::hypot(b.normal_force[k], b.shear_force[k]);
  remember(p, before_);
  return unrest;
}

}  // namespace adit::dem

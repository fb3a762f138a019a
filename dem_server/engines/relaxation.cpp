#include "dem_server/engines/relaxation.hpp"

#include <cmath>

namespace adit::dem {

double kinetic_energy(const Particles& p) {
  double twice = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    twice += p.mass[i] * (p.vx[i] * p.vx[i] + p.vy[i] * p.vy[i]) + p.inertia[i] * p.spin[i] * p.spin[i];
  return twice / 2;
}

double Relaxation::measure(const Particles& p, double kick) {
  double unbalanced = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    unbalanced += p.mass[i] * std::hypot(p.vx[i] - before_.x[i], p.vy[i] - before_.y[i]) / kick;
  remember(p, before_);
  return unbalanced;
}

}  // namespace adit::dem

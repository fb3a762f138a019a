#include "dem_server/participant/relaxation.hpp"

#include <cmath>

namespace adit::dem {

double kinetic_energy(const Particles& p) {
  double twice = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    twice += p.mass[i] * (p.vx[i] * p.vx[i] + p.vy[i] * p.vy[i]) + p.inertia[i] * p.spin[i] * p.spin[i];
  return twice / 2;
}

double internal_force(const Bonds& b) {
  double sum = 0;
  for (std::size_t k = 0; k < b.size(); ++k)
    sum += b.weight[k] * std::hypot(b.normal_force[k], b.shear_force[k]);
  return sum;
}

double Relaxation::measure(const Particles& p, double kick) {
  double unbalanced = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    unbalanced += p.mass[i] * std::hypot(p.vx[i] - before_.x[i], p.vy[i] - before_.y[i]) / kick;
  remember(p, before_);
  return unbalanced;
}

}  // namespace adit::dem

#include "fdm_server/solver/relaxation.hpp"

#include <algorithm>
#include <cmath>

namespace adit::fdm {

double kinetic_energy(const Continuum& continuum) {
  const auto vx = continuum.vx(), vy = continuum.vy(), mass = continuum.masses();
  double twice = 0;
  for (std::size_t i = 0; i < vx.size(); ++i) twice += mass[i] * (vx[i] * vx[i] + vy[i] * vy[i]);
  return twice / 2 + continuum.structures().rotational_energy();
}

Relaxation::Relaxation(const Grid& grid, std::span<const double> zone_weights)
    : vx_(grid.x.size(), 0.0), vy_(grid.x.size(), 0.0) {
  for (std::size_t z = 0; z < grid.zones.size(); ++z)
    factor_.push_back(zone_weights[z] * std::sqrt(area(corners(grid, z))));
}

Unrest Relaxation::measure(const Continuum& continuum, double kick) {
  const auto vx = continuum.vx(), vy = continuum.vy(), mass = continuum.masses();
  Unrest unrest{};
  for (std::size_t i = 0; i < vx.size(); ++i)
    unrest.unbalanced_force += mass[i] * std::hypot(vx[i] - vx_[i], vy[i] - vy_[i]) / kick;
  std::ranges::copy(vx, vx_.begin());
  std::ranges::copy(vy, vy_.begin());
  for (std::size_t z = 0; z < factor_.size(); ++z) {
    const auto [xx, yy, xy] = continuum.zones().stress(z);
    unrest.internal_force += factor_[z] * std::sqrt(xx * xx + yy * yy + 2 * xy * xy);
  }
  return unrest;
}

void Relaxation::stopped() {
  std::ranges::fill(vx_, 0.0);
  std::ranges::fill(vy_, 0.0);
}

}  // namespace adit::fdm

#include "fdm_server/solver/relaxation.hpp"

#include <algorithm>
#include <cmath>

#include "protocol/participant/local_damping.hpp"

namespace adit::fdm {

double kinetic_energy(const Continuum& continuum) {
  const auto vx = continuum.vx(), vy = continuum.vy(), mass = continuum.masses();
  double twice = 0;
  for (std::size_t i = 0; i < vx.size(); ++i) twice += mass[i] * (vx[i] * vx[i] + vy[i] * vy[i]);
  return twice / 2 + continuum.structures().rotational_energy();
}

Relaxation::Relaxation(const Grid& grid, std::span<const double> zone_weights)
    : vx_(grid.x.size(), 0.0), vy_(vx_), fx_(vx_), fy_(vx_) {
  for (std::size_t z = 0; z < grid.zones.size(); ++z)
    factor_.push_back(zone_weights[z] * std::sqrt(area(corners(grid, z))));
}

Unrest Relaxation::measure(const Continuum& continuum, double kick, double local_damping) {
  const auto vx = continuum.vx(), vy = continuum.vy(), mass = continuum.masses();
  Unrest unrest{};
  for (std::size_t i = 0; i < vx.size(); ++i) {
    fx_[i] = mass[i] * protocol::undamped_change(vx[i] - vx_[i], vx_[i], local_damping) / kick;
    fy_[i] = mass[i] * protocol::undamped_change(vy[i] - vy_[i], vy_[i], local_damping) / kick;
    const double force = std::hypot(fx_[i], fy_[i]);
    unrest.unbalanced_force += force;
    if (force > unrest.largest) {
      unrest.largest = force;
      unrest.at = i;
    }
  }
  std::ranges::copy(vx, vx_.begin());
  std::ranges::copy(vy, vy_.begin());
  for (std::size_t z = 0; z < factor_.size(); ++z) {
    const auto [xx, yy, xy] = continuum.zones().stress(z);
    unrest.internal_force += factor_[z] * std::sqrt(xx * xx + yy * yy + 2 * xy * xy);
  }
  return unrest;
}

Vector Relaxation::net(const Continuum& continuum, protocol::IndexRange points) const {
  const std::vector<bool> on_dashpots = continuum.on_dashpots();
  Vector sum;
  for (std::uint32_t i = points.begin; i < points.end; ++i) {
    if (on_dashpots[i]) continue;
    sum.x += fx_[i];
    sum.y += fy_[i];
  }
  return sum;
}

void Relaxation::slowed(double factor) {
  for (auto* velocities : {&vx_, &vy_})
    for (double& velocity : *velocities) velocity *= factor;
}

}  // namespace adit::fdm

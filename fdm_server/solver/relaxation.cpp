#include "fdm_server/solver/relaxation.hpp"

#include <algorithm>
#include <cmath>

#include "protocol/kernels/sums.hpp"
#include "protocol/participant/local_damping.hpp"
#include "protocol/threads/vector_clones.hpp"

namespace adit::fdm {

double kinetic_energy(const Continuum& continuum) {
  const auto vx = continuum.vx(), vy = continuum.vy(), mass = continuum.masses();
  const double twice = protocol::eight_sums(
      0, vx.size(), [&](std::size_t i) { return mass[i] * (vx[i] * vx[i] + vy[i] * vy[i]); });
  return twice / 2 + continuum.structures().rotational_energy();
}

namespace {

// The forces that changed one component of the velocities in a kick [N].
ADIT_VECTOR_CLONES void find_forces(std::span<const double> after, std::span<const double> before,
                                    std::span<const double> mass, double kick, double local_damping,
                                    std::span<double> force) {
#pragma GCC ivdep
  for (std::size_t i = 0; i < force.size(); ++i)
    force[i] = mass[i] * protocol::undamped_change(after[i] - before[i], before[i], local_damping) / kick;
}

}  // namespace

Relaxation::Relaxation(const Grid& grid, std::span<const double> zone_weights)
    : vx_(grid.x.size(), 0.0), vy_(vx_), fx_(vx_), fy_(vx_) {
  for (std::size_t z = 0; z < grid.zones.size(); ++z)
    factor_.push_back(zone_weights[z] * std::sqrt(area(corners(grid, z))));
}

Unrest Relaxation::measure(Continuum& continuum, double kick, double local_damping) {
  const std::span<const double> vx = continuum.vx(), vy = continuum.vy();
  find_forces(vx, vx_, continuum.masses(), kick, local_damping, fx_);
  find_forces(vy, vy_, continuum.masses(), kick, local_damping, fy_);
  const protocol::VectorSizes sizes = protocol::sizes_of(fx_, fy_);
  Unrest unrest{.unbalanced_force = sizes.sum,
                .internal_force = continuum.zones().internal_force(continuum.team(), factor_),
                .largest = sizes.largest,
                .at = sizes.at};
  std::ranges::copy(vx, vx_.begin());
  std::ranges::copy(vy, vy_.begin());
  return unrest;
}

Vector Relaxation::net(const Continuum& continuum, protocol::IndexRange points) const {
  const auto sum_over = [points](const std::vector<double>& forces) {
    return protocol::sum_of(std::span(forces).subspan(points.begin, points.end - points.begin));
  };
  Vector sum{sum_over(fx_), sum_over(fy_)};
  for (const std::uint32_t i : continuum.points_on_dashpots()) {
    if (i < points.begin || i >= points.end) continue;
    sum.x -= fx_[i];
    sum.y -= fy_[i];
  }
  return sum;
}

void Relaxation::slowed(double factor) {
  for (auto* velocities : {&vx_, &vy_})
    for (double& velocity : *velocities) velocity *= factor;
}

}  // namespace adit::fdm

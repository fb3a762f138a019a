#include "fdm_server/structures/bar.hpp"

#include <cmath>

namespace adit::fdm {

double Bar::critical_step() const {
  return 2 / std::sqrt(2 * spring_.stiffness() / mass_);
}

StrainForm Bar::strain() const {
  const auto [p, q] = points_;
  using enum Freedom::Kind;
  return {spring_.stiffness(),
          {{{kX, p}, -chord_.x}, {{kY, p}, -chord_.y}, {{kX, q}, chord_.x}, {{kY, q}, chord_.y}}};
}

double Bar::add_forces(double dt, const PointView& points) {
  const auto [p, q] = points_;
  const double elongation =
      dt * (chord_.x * (points.vx[q] - points.vx[p]) + chord_.y * (points.vy[q] - points.vy[p]));
  const double dissipated = spring_.strain(elongation);
  const double fx = chord_.x * spring_.force(), fy = chord_.y * spring_.force();
  points.fx[p] += fx;
  points.fy[p] += fy;
  points.fx[q] -= fx;
  points.fy[q] -= fy;
  return dissipated;
}

}  // namespace adit::fdm

#include "fdm_server/structures/dowel.hpp"

#include <algorithm>

namespace adit::fdm {

std::array<StrainForm, 2> Dowel::strains() const {
  const auto [p, q] = points_;
  using enum Freedom::Kind;
  return {{{stiffness_, {{{kX, p}, -1}, {{kX, q}, 1}}}, {stiffness_, {{{kY, p}, -1}, {{kY, q}, 1}}}}};
}

double Dowel::add_forces(double dt, const PointView& points) {
  const auto [p, q] = points_;
  const std::array<double, 2> motion{dt * (points.vx[q] - points.vx[p]), dt * (points.vy[q] - points.vy[p])};
  std::array<double, 2> trial{};
  for (std::size_t along = 0; along < 2; ++along) {
    offset_[along] += motion[along];
    trial[along] = force_[along] + stiffness_ * motion[along];
  }
  const double beyond = std::hypot(trial[0], trial[1]) / yield_, kept = beyond > 1 ? 1 / beyond : 1;
  double dissipated = 0;
  for (std::size_t along = 0; along < 2; ++along) {
    const double before = force_[along];
    force_[along] = kept * trial[along];
    dissipated += (1 - kept) * trial[along] * (before + force_[along]) / 2 / stiffness_;
  }
  points.fx[p] += force_[0];
  points.fy[p] += force_[1];
  points.fx[q] -= force_[0];
  points.fy[q] -= force_[1];
  return dissipated;
}

}  // namespace adit::fdm

#include "dem_server/engines/general/observe/crack.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adit::dem {

Place middle_of(const Discs& d, std::uint32_t i, std::uint32_t j) {
  const double dx = d.x[j] - d.x[i], dy = d.y[j] - d.y[i], length = std::hypot(dx, dy);
  const double share = 0.5 + (d.radius[i] - d.radius[j]) / (2 * length);
  return {d.x[i] + share * dx, d.y[i] + share * dy};
}

Crack crack_of_bond(const Model& model, const Solver& solver, std::uint32_t bond) {
  const Joined& joined = model.joined[solver.joined_of_bond()[bond]];
  const Discs& d = model.discs;
  const std::uint32_t i = joined.first, j = joined.second;
  const double length = joined.law == Joined::Law::kParallelBond
                            ? model.parallel_bonds[joined.number].area()
                            : 2 * std::min(d.radius[i], d.radius[j]) / std::numbers::sqrt3;
  // A line has no sense of direction: its angle is brought into (-pi/2, pi/2].
  double orientation = std::atan2(d.x[i] - d.x[j], d.y[j] - d.y[i]);
  if (orientation > std::numbers::pi / 2) orientation -= std::numbers::pi;
  if (orientation <= -std::numbers::pi / 2) orientation += std::numbers::pi;
  const auto [x, y] = middle_of(d, i, j);
  const auto& id = solver.particles().id;
  return {solver.bonds().state[bond], x, y, length, orientation, std::min(id[i], id[j]),
          std::max(id[i], id[j])};
}

}  // namespace adit::dem

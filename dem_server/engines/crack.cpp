#include "dem_server/engines/crack.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "dem_server/packing/meeting_place.hpp"

namespace adit::dem {

Crack crack_between(const Particles& p, std::uint32_t i, std::uint32_t j, double width, BondState mode) {
  if (p.id[i] > p.id[j]) std::swap(i, j);
  const double length = width > 0 ? width : 2 * std::min(p.radius[i], p.radius[j]) / std::numbers::sqrt3;
  // A line has no sense of direction: its angle, a quarter turn less than the bond's, is brought into
  // (-pi/2, pi/2].
  double orientation = std::atan2(p.y[j] - p.y[i], p.x[j] - p.x[i]) - std::numbers::pi / 2;
  if (orientation <= -std::numbers::pi / 2) orientation += std::numbers::pi;
  const auto [x, y] = meeting_place(p, i, j);
  return {mode, x, y, length, orientation, p.id[i], p.id[j]};
}

}  // namespace adit::dem

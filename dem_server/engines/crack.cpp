#include "dem_server/engines/crack.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "dem_server/packing/meeting_place.hpp"

namespace adit::dem {

// A line has no sense of direction: its angle is a quarter turn less than the normal's.
double crack_orientation(double nx, double ny) {
  const double orientation = std::atan2(ny, nx) - std::numbers::pi / 2;
  return orientation <= -std::numbers::pi / 2 ? orientation + std::numbers::pi : orientation;
}

Crack crack_between(const Particles& p, std::uint32_t i, std::uint32_t j, double width, BondState mode) {
  if (p.id[i] > p.id[j]) std::swap(i, j);
  const double length = width > 0 ? width : 2 * std::min(p.radius[i], p.radius[j]) / std::numbers::sqrt3;
  const double orientation = crack_orientation(p.x[j] - p.x[i], p.y[j] - p.y[i]);
  const auto [x, y] = meeting_place(p, i, j);
  return {mode, x, y, length, orientation, p.id[i], p.id[j]};
}

}  // namespace adit::dem

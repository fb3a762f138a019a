#include "fdm_server/interfaces/face.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace adit::fdm {

std::optional<Face::Foot> Face::foot(std::uint32_t point, std::optional<std::uint32_t> from,
                                     const Places& places) const {
  const auto at = places(point);
  std::optional<std::uint32_t> nearest = from;
  double least = from ? project(at, *from, places).square : std::numeric_limits<double>::infinity();
  const auto look = [&](std::uint32_t side) {
    if (has(side, point)) return false;
    const double square = project(at, side, places).square;
    if (!(square < least)) return false;
    least = square;
    nearest = side;
    return true;
  };
  if (from)
    for (bool nearer = true; nearer;) {
      nearer = false;
      for (const std::size_t end : {0, 1})
        if (const auto next = neighbour(*nearest, end)) nearer = look(*next) || nearer;
    }
  else
    for (std::uint32_t side = 0; side < sides_.size(); ++side) look(side);
  if (!nearest) return std::nullopt;

  const double along = project(at, *nearest, places).xi, xi = std::clamp(along, 0.0, 1.0);
  if (along != xi && !neighbour(*nearest, along < 0 ? 0 : 1)) return std::nullopt;
  const auto before = normal_at(*nearest, 0, places), after = normal_at(*nearest, 1, places);
  double nx = (1 - xi) * before[0] + xi * after[0], ny = (1 - xi) * before[1] + xi * after[1];
  const double length = std::hypot(nx, ny);
  nx /= length;
  ny /= length;
  const auto a = places(sides_[*nearest][0]), b = places(sides_[*nearest][1]);
  const double x = (1 - xi) * a[0] + xi * b[0], y = (1 - xi) * a[1] + xi * b[1];
  return Foot{*nearest, xi, nx, ny, (at[0] - x) * nx + (at[1] - y) * ny};
}

std::array<double, 2> Face::across(std::uint32_t side, const Places& places) const {
  const auto a = places(sides_[side][0]), b = places(sides_[side][1]);
  return {a[1] - b[1], b[0] - a[0]};
}

Face::Projection Face::project(const std::array<double, 2>& at, std::uint32_t side,
                               const Places& places) const {
  const auto a = places(sides_[side][0]), b = places(sides_[side][1]);
  const double sx = b[0] - a[0], sy = b[1] - a[1], dx = at[0] - a[0], dy = at[1] - a[1];
  const double xi = (dx * sx + dy * sy) / (sx * sx + sy * sy), within = std::clamp(xi, 0.0, 1.0);
  const double x = dx - within * sx, y = dy - within * sy;
  return {xi, x * x + y * y};
}

std::optional<std::uint32_t> Face::neighbour(std::uint32_t side, std::size_t end) const {
  const auto count = static_cast<std::uint32_t>(sides_.size());
  const std::uint32_t other = (side + (end == 0 ? count - 1 : 1)) % count;
  if (other == side || sides_[other][1 - end] != sides_[side][end]) return std::nullopt;
  return other;
}

std::array<double, 2> Face::normal_at(std::uint32_t side, std::size_t end, const Places& places) const {
  auto [nx, ny] = across(side, places);
  if (const auto beside = neighbour(side, end)) {
    const auto [ox, oy] = across(*beside, places);
    if (nx * ox + ny * oy > corner_ * std::hypot(nx, ny) * std::hypot(ox, oy)) {
      nx += ox;
      ny += oy;
    }
  }
  const double length = std::hypot(nx, ny);
  return {nx / length, ny / length};
}

}  // namespace adit::fdm

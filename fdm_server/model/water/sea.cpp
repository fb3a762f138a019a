#include "fdm_server/model/water/sea.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "fdm_server/grid/edges.hpp"
#include "protocol/errors.hpp"

namespace adit::fdm {
namespace {

// Sides of one zone that is there.
std::vector<Edge> outer_sides(const Grid& grid, std::span<const double> weights) {
  Grid left{grid.x, grid.y, {}};
  std::vector<std::size_t> numbers;
  for (std::size_t z = 0; z < grid.own_zones(); ++z) {
    if (weights[z] == 0) continue;
    left.zones.push_back(grid.zones[z]);
    numbers.push_back(z);
  }
  std::vector<Edge> sides = boundary(number_edges(left));
  for (Edge& side : sides) side.zone = static_cast<std::uint32_t>(numbers[side.zone]);
  return sides;
}

double share_of(const SideShares& shares, const Grid& grid, const Edge& side) {
  if (shares.empty()) return 1;
  const auto at = std::ranges::find(grid.zones[side.zone], side.from);
  return shares[side.zone][static_cast<std::size_t>(at - grid.zones[side.zone].begin())];
}

// Where a vertical line through x meets a side; nothing where it does not.
std::optional<double> height_at(const Grid& grid, const Edge& side, double x) {
  const double x0 = grid.x[side.from], x1 = grid.x[side.to];
  if ((x0 <= x) == (x1 <= x)) return std::nullopt;
  return std::lerp(grid.y[side.from], grid.y[side.to], (x - x0) / (x1 - x0));
}

// A point outside of the ground, or on the other side of an interface.
struct Outside {
  bool below_sky = true;               // a line upwards from there meets no side
  std::optional<std::uint32_t> above;  // the zone that lies straight below it
};
Outside look(const Grid& grid, const std::vector<Edge>& sides, double x, double y) {
  Outside found;
  double highest = -std::numeric_limits<double>::infinity();
  for (const Edge& side : sides) {
    const std::optional<double> height = height_at(grid, side, x);
    if (!height) continue;
    if (*height > y) {
      found.below_sky = false;
    } else if (*height > highest) {
      highest = *height;
      found.above = side.zone;
    }
  }
  return found;
}

}  // namespace

std::vector<WetSide> sides_under_sea(const WaterAtRest& water, const Grid& grid,
                                     std::span<const double> weights, const SideShares& shares) {
  constexpr double kDownwards = -1e-6;  // of the normal
  constexpr double kOutside = 1e-3;     // of a side's length
  constexpr double kRounding = 1e-9;    // of shares
  const double close = tolerance(grid);
  const std::vector<Edge> sides = outer_sides(grid, weights);
  const auto [left, right] = std::ranges::minmax(std::span(grid.x).first(grid.own_points()));
  std::vector<WetSide> wet;
  for (const Edge& side : sides) {
    const auto from = static_cast<std::uint32_t>(side.from), to = static_cast<std::uint32_t>(side.to);
    const double dx = grid.x[to] - grid.x[from], dy = grid.y[to] - grid.y[from];  // the normal is (dy, -dx)
    const auto is_at = [&](double end) {
      return std::abs(grid.x[from] - end) <= close && std::abs(grid.x[to] - end) <= close;
    };
    if (-dx < kDownwards * std::hypot(dx, dy) || is_at(left) || is_at(right)) continue;
    const double share = share_of(shares, grid, side);
    if (share < kRounding) continue;
    const double x = (grid.x[from] + grid.x[to]) / 2, y = (grid.y[from] + grid.y[to]) / 2;
    const double x_outside = x + kOutside * dy, y_outside = y - kOutside * dx;
    const auto [below_sky, above] = look(grid, sides, x_outside, y_outside);
    if (!below_sky) continue;
    const double level = water.level_at(x_outside, y_outside, above);
    const auto [lower, upper] = std::minmax(grid.y[from], grid.y[to]);
    if (!is_below(lower, level, grid)) continue;
    protocol::require(
        share > 1 - kRounding, "water",
        fmt::format("stands on the ground at ({:g}, {:g}) m, in an overlap with another model, which would "
                    "not bear it; lower its level, or keep the overlap below the surface",
                    x, y));
    wet.push_back({{from, to}, level, is_below(upper, level, grid)});
  }
  return wet;
}

double level_on(const WaterAtRest& water, const Grid& grid, const FreeFieldColumn& column) {
  return water.level_at(grid.x[column.side.back()], grid.y[column.top()], column.edges.back().zone);
}

bool is_below(double y, double level, const Grid& grid) {
  return y <= level + tolerance(grid);
}

Load weight_of_sea(const WaterAtRest& water, const Grid& grid, std::span<const double> weights,
                   const SideShares& shares, std::span<const FreeFieldColumn> columns) {
  Load load;
  const auto add = [&load](std::uint32_t point, double fx, double fy) {
    load.points.push_back(point);
    load.fx.push_back(fx);
    load.fy.push_back(fy);
  };
  for (const auto& [points, level, whole] : sides_under_sea(water, grid, weights, shares)) {
    const auto [from, to] = points;
    const double dx = grid.x[to] - grid.x[from], dy = grid.y[to] - grid.y[from];  // the normal is (dy, -dx)
    // What of the side is below water, from its lower end, and the ends' parts of a pressure that is linear
    // there.
    const auto [low, high] = grid.y[from] <= grid.y[to] ? std::pair{from, to} : std::pair{to, from};
    const double wet = whole ? 1 : (level - grid.y[low]) / (grid.y[high] - grid.y[low]);
    const double p_low = water.pressure_below(level, grid.y[low]),
                 p_high = water.pressure_below(level, grid.y[high]);
    const double of_high = wet * wet * (p_low + 2 * p_high) / 6,
                 of_low = wet * (p_low + p_high) / 2 - of_high;
    add(low, -of_low * dy, of_low * dx);
    add(high, -of_high * dy, of_high * dx);
  }
  for (const FreeFieldColumn& column : columns)
    add(column.top(), 0,
        -water.pressure_below(level_on(water, grid, column), grid.y[column.top()]) * column.width);
  return load;
}

}  // namespace adit::fdm

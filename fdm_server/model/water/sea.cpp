#include "fdm_server/model/water/sea.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "fdm_server/grid/edges.hpp"
#include "protocol/errors.hpp"
#include "protocol/ground/water_at_rest.hpp"

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

// Whether a line upwards from (x, y), which lies outside of the ground or on the other side of an interface,
// crosses none of the sides.
bool is_below_sky(const Grid& grid, const std::vector<Edge>& sides, double x, double y) {
  return std::ranges::none_of(sides, [&](const Edge& side) {
    const double x0 = grid.x[side.from], x1 = grid.x[side.to];
    if ((x0 <= x) == (x1 <= x)) return false;
    return std::lerp(grid.y[side.from], grid.y[side.to], (x - x0) / (x1 - x0)) > y;
  });
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
    const double level = water.level_on(side.zone, x_outside, y_outside);
    if (std::max(grid.y[from], grid.y[to]) > level + close ||
        !is_below_sky(grid, sides, x_outside, y_outside))
      continue;
    protocol::require(
        share > 1 - kRounding, "water",
        fmt::format("stands on the ground at ({:g}, {:g}) m, in an overlap with another model, which would "
                    "not bear it; lower its level, or keep the overlap below the surface",
                    x, y));
    wet.push_back({{from, to}, level});
  }
  return wet;
}

double level_on(const WaterAtRest& water, const Grid& grid, const FreeFieldColumn& column) {
  return water.level_on(column.edges.back().zone, grid.x[column.side.back()], grid.y[column.top()]);
}

Load weight_of_sea(const scene::Water& stated, const WaterAtRest& water, const Grid& grid,
                   std::span<const double> weights, const SideShares& shares,
                   std::span<const FreeFieldColumn> columns) {
  Load load;
  const auto pressure = [&](std::uint32_t point, double level) {
    return protocol::pressure_at_rest(stated, level, grid.y[point]);
  };
  const auto add = [&load](std::uint32_t point, double fx, double fy) {
    load.points.push_back(point);
    load.fx.push_back(fx);
    load.fy.push_back(fy);
  };
  for (const auto& [points, level] : sides_under_sea(water, grid, weights, shares)) {
    const auto [from, to] = points;
    const double dx = grid.x[to] - grid.x[from], dy = grid.y[to] - grid.y[from];  // the normal is (dy, -dx)
    // The ends' shares of a pressure that is linear between them.
    for (const auto& [point, other] : {std::pair{from, to}, {to, from}}) {
      const double share = (2 * pressure(point, level) + pressure(other, level)) / 6;
      add(point, -share * dy, share * dx);
    }
  }
  for (const FreeFieldColumn& column : columns)
    add(column.top(), 0, -pressure(column.top(), level_on(water, grid, column)) * column.width);
  return load;
}

}  // namespace adit::fdm

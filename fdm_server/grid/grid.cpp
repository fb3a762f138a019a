#include "fdm_server/grid/grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "fdm_server/grid/edges.hpp"

namespace adit::fdm {
namespace {

// Point i of n + 1 equally spaced ones; both ends exact.
double spaced(double first, double last, std::size_t i, std::size_t n) {
  return i == n ? last : first + (last - first) * static_cast<double>(i) / static_cast<double>(n);
}

}  // namespace

Corners corners(const Grid& grid, std::size_t zone) {
  const std::size_t of_points = grid.zones.size() - grid.own_corners.size();
  if (zone >= of_points) return grid.own_corners[zone - of_points];
  Corners result{};
  for (std::size_t c = 0; c < 4; ++c) {
    result.x[c] = grid.x[grid.zones[zone][c]];
    result.y[c] = grid.y[grid.zones[zone][c]];
  }
  return result;
}

double area(const Corners& c) {
  return 0.5 * ((c.x[2] - c.x[0]) * (c.y[3] - c.y[1]) - (c.x[3] - c.x[1]) * (c.y[2] - c.y[0]));
}

// The centroid of the two triangles beside a diagonal, weighted by area and relative to a corner, so that far
// from the origin no digit is lost.
std::array<double, 2> centroid(const Corners& c) {
  std::array<double, 3> x{}, y{};
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = c.x[i + 1] - c.x[0];
    y[i] = c.y[i + 1] - c.y[0];
  }
  const double a = x[0] * y[1] - x[1] * y[0], b = x[1] * y[2] - x[2] * y[1], third = 1 / (3 * (a + b));
  return {c.x[0] + third * (a * (x[0] + x[1]) + b * (x[1] + x[2])),
          c.y[0] + third * (a * (y[0] + y[1]) + b * (y[1] + y[2]))};
}

geometry::BoundingBox bounds(const Grid& grid) {
  const auto [x_min, x_max] = std::ranges::minmax(grid.x);
  const auto [y_min, y_max] = std::ranges::minmax(grid.y);
  return {x_min, x_max, y_min, y_max};
}

double tolerance(const Grid& grid) {
  const auto box = bounds(grid);
  return 1e-9 * std::hypot(box.x_max - box.x_min, box.y_max - box.y_min);
}

Grid make_grid(const Block& block) {
  const std::size_t columns = block.zones_x, rows = block.zones_y;
  Grid grid;
  grid.x.reserve((columns + 1) * (rows + 1));
  grid.y.reserve((columns + 1) * (rows + 1));
  for (std::size_t j = 0; j <= rows; ++j)
    for (std::size_t i = 0; i <= columns; ++i) {
      grid.x.push_back(spaced(block.x_min, block.x_max, i, columns));
      grid.y.push_back(spaced(block.y_min, block.y_max, j, rows));
    }
  grid.zones.reserve(columns * rows);
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const auto lower = static_cast<std::int32_t>(j * (columns + 1) + i);
      const auto upper = static_cast<std::int32_t>(lower + columns + 1);
      grid.zones.push_back({lower, lower + 1, upper + 1, upper});
    }
  grid.boundary = boundary(number_edges(grid));
  return grid;
}

void compact(Grid& grid, std::vector<double>& weights) {
  std::vector<std::int32_t> point_number(grid.x.size(), -1), zone_number(grid.zones.size(), -1);
  std::int32_t zones = 0;
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    if (weights[z] == 0) continue;
    for (const auto point : grid.zones[z]) point_number[point] = 0;
    // In place: the number of a kept zone or point never exceeds its old one.
    weights[zones] = weights[z];
    grid.zones[zones] = grid.zones[z];
    zone_number[z] = zones++;
  }
  grid.zones.resize(zones);
  weights.resize(zones);

  std::int32_t points = 0;
  for (std::size_t i = 0; i < point_number.size(); ++i) {
    if (point_number[i] < 0) continue;
    grid.x[points] = grid.x[i];
    grid.y[points] = grid.y[i];
    point_number[i] = points++;
  }
  grid.x.resize(points);
  grid.y.resize(points);
  for (auto& zone : grid.zones)
    for (auto& point : zone) point = point_number[point];

  const auto renumber = [&](std::vector<Edge>& edges) {
    std::erase_if(edges, [&](const Edge& edge) { return zone_number[edge.zone] < 0; });
    for (auto& [from, to, zone] : edges) {
      from = point_number[from];
      to = point_number[to];
      zone = zone_number[zone];
    }
  };
  renumber(grid.boundary);
  for (Group& group : grid.groups) {
    renumber(group.edges);
    std::erase_if(group.zones, [&](std::uint32_t zone) { return zone_number[zone] < 0; });
    for (auto& zone : group.zones) zone = zone_number[zone];
  }
}

std::vector<double> lumped_masses(const Grid& grid, std::span<const double> weights, double density) {
  return lumped_masses(grid, weights, std::vector<double>(grid.zones.size(), density));
}

std::vector<double> lumped_masses(const Grid& grid, std::span<const double> weights,
                                  std::span<const double> densities) {
  std::vector<double> masses(grid.x.size(), 0.0);
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const double share = weights[z] * densities[z] * area(corners(grid, z)) / 4;
    for (const auto point : grid.zones[z]) masses[point] += share;
  }
  return masses;
}

}  // namespace adit::fdm

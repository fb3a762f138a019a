#include "fdm_server/grid/grid.hpp"

#include <algorithm>
#include <cstddef>

namespace adit::fdm {
namespace {

// Point i of n + 1 equally spaced ones; both ends exact.
double spaced(double first, double last, std::size_t i, std::size_t n) {
  return i == n ? last : first + (last - first) * static_cast<double>(i) / static_cast<double>(n);
}

}  // namespace

Corners corners(const Grid& grid, const ZonePoints& zone) {
  Corners result{};
  for (std::size_t c = 0; c < 4; ++c) {
    result.x[c] = grid.x[zone[c]];
    result.y[c] = grid.y[zone[c]];
  }
  return result;
}

double area(const Corners& c) {
  return 0.5 * ((c.x[2] - c.x[0]) * (c.y[3] - c.y[1]) - (c.x[3] - c.x[1]) * (c.y[2] - c.y[0]));
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
  return grid;
}

std::vector<double> sample_points(const Block& block) {
  const std::size_t columns = 2 * std::size_t{block.zones_x}, rows = 2 * std::size_t{block.zones_y};
  std::vector<double> points;
  points.reserve(2 * (columns + 1) * (rows + 1));
  for (std::size_t j = 0; j <= rows; ++j)
    for (std::size_t i = 0; i <= columns; ++i) {
      points.push_back(spaced(block.x_min, block.x_max, i, columns));
      points.push_back(spaced(block.y_min, block.y_max, j, rows));
    }
  return points;
}

std::vector<double> zone_weights(const Block& block, std::span<const double> samples, double floor) {
  constexpr std::array<double, 3> kSimpson{1, 4, 1};
  const std::size_t stride = 2 * std::size_t{block.zones_x} + 1;
  std::vector<double> weights;
  weights.reserve(std::size_t{block.zones_x} * block.zones_y);
  for (std::size_t j = 0; j < block.zones_y; ++j)
    for (std::size_t i = 0; i < block.zones_x; ++i) {
      double sum = 0;
      bool exists = false;
      for (std::size_t b = 0; b < 3; ++b)
        for (std::size_t a = 0; a < 3; ++a) {
          const double sample = samples[(2 * j + b) * stride + 2 * i + a];
          sum += kSimpson[a] * kSimpson[b] * sample;
          exists = exists || sample != 0;
        }
      weights.push_back(exists ? std::max(sum / 36, floor) : 0.0);
    }
  return weights;
}

void compact(Grid& grid, std::vector<double>& weights) {
  std::vector<std::int32_t> number(grid.x.size(), -1);
  std::size_t zones = 0;
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    if (weights[z] == 0) continue;
    for (const auto point : grid.zones[z]) number[point] = 0;
    weights[zones] = weights[z];
    grid.zones[zones++] = grid.zones[z];
  }
  grid.zones.resize(zones);
  weights.resize(zones);

  std::int32_t points = 0;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] < 0) continue;
    grid.x[points] = grid.x[i];
    grid.y[points] = grid.y[i];
    number[i] = points++;
  }
  grid.x.resize(points);
  grid.y.resize(points);
  for (auto& zone : grid.zones)
    for (auto& point : zone) point = number[point];
}

std::vector<double> lumped_masses(const Grid& grid, std::span<const double> weights, double density) {
  return lumped_masses(grid, weights, std::vector<double>(grid.zones.size(), density));
}

std::vector<double> lumped_masses(const Grid& grid, std::span<const double> weights,
                                  std::span<const double> densities) {
  std::vector<double> masses(grid.x.size(), 0.0);
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const double share = weights[z] * densities[z] * area(corners(grid, grid.zones[z])) / 4;
    for (const auto point : grid.zones[z]) masses[point] += share;
  }
  return masses;
}

}  // namespace adit::fdm

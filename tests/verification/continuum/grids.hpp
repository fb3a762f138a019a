// Families of grids for studies of convergence: halving the zones keeps their shapes' distortion, as a
// fraction of the zone.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "fdm_server/grid/grid.hpp"

namespace adit::fdm::test {

// n x n zones on the unit square with its upper edge at y = 0.
inline Grid regular_grid(std::uint32_t n) {
  return make_grid({0, 1, -1, 0, n, n});
}

// All points moved by a map of the plane.
inline Grid mapped(Grid grid, const std::function<std::array<double, 2>(double, double)>& map) {
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    const auto [x, y] = map(grid.x[i], grid.y[i]);
    grid.x[i] = x;
    grid.y[i] = y;
  }
  return grid;
}

// Parallelograms of 63 degrees.
inline Grid sheared_grid(std::uint32_t n) {
  return mapped(regular_grid(n), [](double x, double y) { return std::array{x + 0.5 * y, y}; });
}

// Zones that change slowly from place to place: the shapes tend to parallelograms as they are halved.
inline Grid smooth_grid(std::uint32_t n) {
  return mapped(regular_grid(n), [](double x, double y) {
    const double bend = 0.07 * std::sin(2 * std::numbers::pi * x) * std::sin(2 * std::numbers::pi * y);
    return std::array{x + bend, y - bend};
  });
}

// Trapezoids with vertical parallel sides, of 0.7 and 1.3 of the mean height in turn, so that halving never
// brings parallelograms (Arnold, Boffi & Falk 2002, Math. Comput. 71).
inline Grid trapezoid_grid(std::uint32_t n) {
  const double h = 1.0 / n;
  Grid grid = regular_grid(n);
  for (std::uint32_t j = 1; j < n; j += 2)
    for (std::uint32_t i = 0; i <= n; ++i) grid.y[j * (n + 1) + i] += i % 2 == 0 ? 0.3 * h : -0.3 * h;
  return grid;
}

// Every point moved at random by up to a fifth of a zone, those of the edges along them.
inline Grid random_grid(std::uint32_t n) {
  const double h = 1.0 / n;
  std::mt19937 random(n);
  std::uniform_real_distribution<double> shift(-0.2 * h, 0.2 * h);
  Grid grid = regular_grid(n);
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i) {
      const double x = shift(random), y = shift(random);
      if (i != 0 && i != n) grid.x[j * (n + 1) + i] += x;
      if (j != 0 && j != n) grid.y[j * (n + 1) + i] += y;
    }
  return grid;
}

struct GridFamily {
  std::string name;
  Grid (*make)(std::uint32_t n);
  bool keeps_distortion;  // the zones do not tend to parallelograms
};
inline const GridFamily kGridFamilies[] = {{"Regular", regular_grid, false},
                                           {"Parallelograms", sheared_grid, false},
                                           {"SmoothlyDistorted", smooth_grid, false},
                                           {"Trapezoids", trapezoid_grid, true},
                                           {"Random", random_grid, true}};

// Points that belong to the edge of the grid, ascending.
inline std::vector<std::uint32_t> edge_points(const Grid& grid) {
  std::vector<double> turn(grid.x.size(), 0);  // sum of the zones' angles at the point: 2 pi inside
  for (const auto& zone : grid.zones)
    for (std::size_t c = 0; c < 4; ++c) {
      const auto a = zone[c], b = zone[(c + 1) % 4], d = zone[(c + 3) % 4];
      const double x1 = grid.x[b] - grid.x[a], y1 = grid.y[b] - grid.y[a];
      const double x2 = grid.x[d] - grid.x[a], y2 = grid.y[d] - grid.y[a];
      turn[a] += std::atan2(x1 * y2 - x2 * y1, x1 * x2 + y1 * y2);
    }
  std::vector<std::uint32_t> points;
  for (std::uint32_t i = 0; i < turn.size(); ++i)
    if (turn[i] < 2 * std::numbers::pi - 1e-6) points.push_back(i);
  return points;
}

}  // namespace adit::fdm::test

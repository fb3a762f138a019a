// Grids and assembled matrices that several tests use.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <cstdint>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/zones/elastic/elastic_zones.hpp"

namespace adit::fdm::test {

inline constexpr double kYoung = 25e9, kPoisson = 0.2, kDensity = 2500;
inline constexpr ZoneKind kKinds[] = {ZoneKind::kAssumedStrain, ZoneKind::kMixedDiscretization};

inline std::vector<double> ones(const Grid& grid) {
  return std::vector<double>(grid.zones.size(), 1.0);
}

// A grid whose inner points are moved by up to a fifth of a zone, without any pattern.
inline Grid distorted_grid(const Block& block) {
  Grid grid = make_grid(block);
  const double hx = (block.x_max - block.x_min) / block.zones_x;
  const double hy = (block.y_max - block.y_min) / block.zones_y;
  for (std::uint32_t j = 1; j < block.zones_y; ++j)
    for (std::uint32_t i = 1; i < block.zones_x; ++i) {
      const std::size_t point = j * (block.zones_x + 1) + i;
      grid.x[point] += 0.2 * hx * std::sin(12.9 * static_cast<double>(point));
      grid.y[point] += 0.2 * hy * std::sin(78.2 * static_cast<double>(point) + 1);
    }
  return grid;
}

// Forces of unstressed zones at all points, x0 y0 x1 y1 …, after the displacement `u`.
inline Eigen::VectorXd forces(ZoneKind kind, const Grid& grid, const PlaneLaw& law,
                              const Eigen::VectorXd& u) {
  const std::size_t n = grid.x.size();
  std::vector<double> vx(n), vy(n), fx(n), fy(n);
  for (std::size_t i = 0; i < n; ++i) {
    vx[i] = u[2 * i];
    vy[i] = u[2 * i + 1];
  }
  ElasticZones zones(kind, grid, law, ones(grid));
  zones.follow(vx.data(), vy.data());
  zones.add_forces(1.0, {vx.data(), vy.data(), fx.data(), fy.data()});
  Eigen::VectorXd result(2 * n);
  for (std::size_t i = 0; i < n; ++i) {
    result[2 * i] = fx[i];
    result[2 * i + 1] = fy[i];
  }
  return result;
}

// Stiffness of the whole grid, column by column from the kernel.
inline Eigen::MatrixXd assembled_stiffness(ZoneKind kind, const Grid& grid, const PlaneLaw& law) {
  const Eigen::Index n = 2 * static_cast<Eigen::Index>(grid.x.size());
  Eigen::MatrixXd stiffness(n, n);
  for (Eigen::Index column = 0; column < n; ++column)
    stiffness.col(column) = -forces(kind, grid, law, Eigen::VectorXd::Unit(n, column));
  return stiffness;
}

}  // namespace adit::fdm::test

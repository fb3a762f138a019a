#include "fdm_server/zones/critical_step.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

namespace adit::fdm {

namespace {

MakeZones maker(ZoneKind kind, const PlaneLaw& law) {
  return [kind, law](const Grid& grid) {
    return make_zones(kind, grid, law, std::vector<double>(grid.zones.size(), 1.0));
  };
}

Eigen::Matrix<double, 8, 8> zone_stiffness(const Corners& corners, const MakeZones& make) {
  const Grid grid{{corners.x.begin(), corners.x.end()}, {corners.y.begin(), corners.y.end()}, {{0, 1, 2, 3}}};
  Eigen::Matrix<double, 8, 8> stiffness;
  for (int column = 0; column < 8; ++column) {
    std::array<double, 4> vx{}, vy{}, fx{}, fy{};
    (column % 2 == 0 ? vx : vy)[column / 2] = 1;
    const auto zone = make(grid);
    zone->follow(vx.data(), vy.data());
    zone->add_forces(1.0, {vx.data(), vy.data(), fx.data(), fy.data()});
    for (int point = 0; point < 4; ++point) {
      stiffness(2 * point, column) = -fx[point];
      stiffness(2 * point + 1, column) = -fy[point];
    }
  }
  return stiffness;
}

}  // namespace

Eigen::Matrix<double, 8, 8> zone_stiffness(ZoneKind kind, const Corners& corners, const PlaneLaw& law) {
  return zone_stiffness(corners, maker(kind, law));
}

double critical_step(ZoneKind kind, const Grid& grid, const PlaneLaw& law, double density) {
  return critical_step(grid, density, maker(kind, law));
}

double critical_step(const Grid& grid, double density, const MakeZones& make) {
  double largest = 0;
  for (const auto& shape : lay_out(grid).shapes) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 8, 8>> solver(zone_stiffness(shape, make),
                                                                            Eigen::EigenvaluesOnly);
    largest = std::max(largest, solver.eigenvalues().maxCoeff() / (density * area(shape) / 4));
  }
  return 2 / std::sqrt(largest);
}

}  // namespace adit::fdm

#include "fdm_server/zones/critical_step.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace adit::fdm {

namespace {

MakeZones maker(ZoneKind kind, const PlaneLaw& law) {
  return [kind, law](const Grid& grid) {
    return make_zones(kind, grid, law, std::vector<double>(grid.zones.size(), 1.0));
  };
}

using Stiffness = Eigen::Matrix<double, 8, 8>;

// Zones apart, each with four points of its own.
Grid apart(std::span<const Corners> shapes) {
  Grid grid;
  for (const Corners& corners : shapes) {
    const auto first = static_cast<std::int32_t>(grid.x.size());
    grid.x.insert(grid.x.end(), corners.x.begin(), corners.x.end());
    grid.y.insert(grid.y.end(), corners.y.begin(), corners.y.end());
    grid.zones.push_back({first, first + 1, first + 2, first + 3});
  }
  return grid;
}

std::vector<Stiffness> stiffnesses(std::span<const Corners> shapes, const MakeZones& make) {
  const Grid grid = apart(shapes);
  std::vector<Stiffness> found(shapes.size());
  for (int column = 0; column < 8; ++column) {
    std::vector<double> vx(grid.x.size()), vy = vx, fx = vx, fy = vx;
    for (std::size_t z = 0; z < shapes.size(); ++z) (column % 2 == 0 ? vx : vy)[4 * z + column / 2] = 1;
    const auto zones = make(grid);
    zones->follow(vx.data(), vy.data());
    zones->add_forces(1.0, {vx.data(), vy.data(), fx.data(), fy.data()});
    for (std::size_t z = 0; z < shapes.size(); ++z)
      for (int point = 0; point < 4; ++point) {
        found[z](2 * point, column) = -fx[4 * z + point];
        found[z](2 * point + 1, column) = -fy[4 * z + point];
      }
  }
  return found;
}

}  // namespace

Eigen::Matrix<double, 8, 8> zone_stiffness(ZoneKind kind, const Corners& corners, const PlaneLaw& law) {
  return stiffnesses(std::array{corners}, maker(kind, law)).front();
}

double critical_step(ZoneKind kind, const Grid& grid, const PlaneLaw& law, double density) {
  return critical_step(grid, density, maker(kind, law));
}

double critical_step(const Grid& grid, double density, const MakeZones& make) {
  constexpr std::size_t kAtOnce = 1024;  // few enough for the cache
  const auto& shapes = lay_out(grid).shapes;
  double largest = 0;
  for (std::size_t begin = 0; begin < shapes.size(); begin += kAtOnce) {
    const auto some = std::span(shapes).subspan(begin, std::min(kAtOnce, shapes.size() - begin));
    const auto found = stiffnesses(some, make);
    for (std::size_t z = 0; z < some.size(); ++z) {
      const Eigen::SelfAdjointEigenSolver<Stiffness> solver(found[z], Eigen::EigenvaluesOnly);
      largest = std::max(largest, solver.eigenvalues().maxCoeff() / (density * area(some[z]) / 4));
    }
  }
  return 2 / std::sqrt(largest);
}

}  // namespace adit::fdm

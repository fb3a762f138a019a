#include "fdm_server/zones/critical_step.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "fdm_server/zones/elastic/elastic_zones.hpp"
#include "fdm_server/zones/nonlinear/nonlinear_zones.hpp"
#include "fdm_server/zones/shape/hourglass.hpp"
#include "fdm_server/zones/zone_set.hpp"

namespace adit::fdm {
namespace {

// Makes the zones of a grid, unstressed, with weights 1.
using MakeZones = std::function<std::unique_ptr<ZoneKernel>(const Grid& grid)>;

MakeZones elastic_zones(ZoneKind kind, const PlaneLaw& law) {
  return [kind, law](const Grid& grid) {
    return std::make_unique<ElasticZones>(kind, grid, law, std::vector<double>(grid.zones.size(), 1.0));
  };
}

// The stiffness is measured on displacements of 1 m, hence without the law's strength and in small strain.
MakeZones nonlinear_zones(ZoneKind kind, const Material& material) {
  const auto [bulk, shear] = material.stiffest();
  const Material stiffest{material.density, 9 * bulk * shear / (3 * bulk + shear),
                          (3 * bulk - 2 * shear) / (6 * bulk + 2 * shear)};
  return [kind, elastic = stiffest](const Grid& grid) {
    return std::make_unique<NonlinearZones>(kind, grid, elastic, std::vector<double>(grid.zones.size(), 1.0),
                                            false);
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

// Of water that follows the volume of the pores (water/pore_water.hpp): M A b b^T.
Stiffness water_stiffness(const Corners& zone, double stiffness) {
  const MeanGradient b = mean_gradient(zone);
  const Eigen::Vector<double, 8> gradient{b.x0, b.y0, b.x1, b.y1, -b.x0, -b.y0, -b.x1, -b.y1};
  return stiffness * area(zone) * gradient * gradient.transpose();
}

// Of each zone. `water`: the stiffness of what its pores hold [Pa].
std::vector<double> steps_of(const Grid& grid, double density, double water, const MakeZones& make) {
  constexpr std::size_t kAtOnce = 1024;  // few enough for the cache
  const ZoneLayout layout = lay_out(grid);
  std::vector<double> of_shape, of_zone;
  for (std::size_t begin = 0; begin < layout.shapes.size(); begin += kAtOnce) {
    const auto some =
        std::span(layout.shapes).subspan(begin, std::min(kAtOnce, layout.shapes.size() - begin));
    const auto found = stiffnesses(some, make);
    for (std::size_t s = 0; s < some.size(); ++s) {
      const Eigen::SelfAdjointEigenSolver<Stiffness> solver(found[s] + water_stiffness(some[s], water),
                                                            Eigen::EigenvaluesOnly);
      if (solver.info() != Eigen::Success) {  // a stiffness beyond all numbers, which allows no step
        of_shape.push_back(0);
        continue;
      }
      const double squared = solver.eigenvalues().maxCoeff() / (density * area(some[s]) / 4);
      of_shape.push_back(squared > 0 ? 2 / std::sqrt(squared) : std::numeric_limits<double>::infinity());
    }
  }
  for (const ZoneRun& run : layout.runs) of_zone.insert(of_zone.end(), run.count, of_shape[run.shape]);
  return of_zone;
}

}  // namespace

Eigen::Matrix<double, 8, 8> zone_stiffness(ZoneKind kind, const Corners& corners, const PlaneLaw& law) {
  return stiffnesses(std::array{corners}, elastic_zones(kind, law)).front();
}

double critical_step(ZoneKind kind, const Grid& grid, const PlaneLaw& law, double density) {
  return std::ranges::min(steps_of(grid, density, 0, elastic_zones(kind, law)));
}

std::vector<double> zone_steps(ZoneKind kind, const Grid& grid, const Ground& ground, Drainage drainage) {
  std::vector<double> steps(grid.zones.size());
  for (std::size_t m = 0; m < ground.materials.size(); ++m) {
    const Material& material = ground.materials[m];
    const MakeZones make = ground.is_elastic(material) ? elastic_zones(kind, ground.plane_law(material))
                                                       : nonlinear_zones(kind, material);
    const double water = drainage == Drainage::kUndrained ? material.water_stiffness() : 0;
    const std::vector<double> own =
        steps_of(zones_of_material(grid, ground, m), material.density, water, make);
    for (std::size_t z = 0, k = 0; z < steps.size(); ++z)
      if (ground.of_zone[z] == m) steps[z] = own[k++] / std::sqrt(ground.stiffness_of(z));
  }
  return steps;
}

CriticalZone critical_zone(ZoneKind kind, const Grid& grid, const Ground& ground, Drainage drainage) {
  const std::vector<double> steps = zone_steps(kind, grid, ground, drainage);
  if (steps.empty()) return {};
  const auto smallest = std::ranges::min_element(steps);
  return {*smallest, centroid(corners(grid, static_cast<std::size_t>(smallest - steps.begin())))};
}

}  // namespace adit::fdm

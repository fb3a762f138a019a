// Rings of zones around a lined circular hole, brought to rest under given displacements of the rim.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "fdm_server/supports/lining.hpp"
#include "fdm_server/zones/critical_step.hpp"
#include "tests/unit/fdm_server/structures/frames.hpp"

namespace adit::fdm::test {

// Points counter-clockwise from the right, ring by ring outwards; zones about as long as wide.
inline Grid rings(double inner, double outer, std::uint32_t around) {
  const double decades = std::log(outer / inner);
  const auto count =
      static_cast<std::uint32_t>(std::lround(decades / std::log1p(2 * std::numbers::pi / around)));
  Grid grid;
  for (std::uint32_t j = 0; j <= count; ++j) {
    const Grid ring = circle(inner * std::exp(decades * j / count), around);
    grid.x.insert(grid.x.end(), ring.x.begin(), ring.x.end());
    grid.y.insert(grid.y.end(), ring.y.begin(), ring.y.end());
  }
  for (std::uint32_t j = 0; j < count; ++j)
    for (std::uint32_t i = 0; i < around; ++i) {
      const auto at = [&](std::uint32_t ring, std::uint32_t side) {
        return static_cast<std::int32_t>(ring * around + side % around);
      };
      grid.zones.push_back({at(j, i), at(j + 1, i), at(j + 1, i + 1), at(j, i + 1)});
    }
  return grid;
}

// Displacement of a place on the rim [m].
using Rim = std::function<std::array<double, 2>(double x, double y)>;

// Forces in the lining at rest, at each node from the right. Statics do not depend on masses: here those with
// which every zone and every beam has the critical step 1.
inline std::vector<LiningForces> forces_at_rest(const Grid& grid, std::uint32_t around, const PlaneLaw& law,
                                                Section section, const Rim& rim) {
  const std::vector<double> unweighted(grid.zones.size(), 1.0);
  std::vector<double> masses(grid.x.size(), 0.0);
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const auto c = corners(grid, z);
    const Grid alone{{c.x.begin(), c.x.end()}, {c.y.begin(), c.y.end()}, {{0, 1, 2, 3}}};
    const double density = std::pow(critical_step(ZoneKind::kAssumedStrain, alone, law, 1.0), -2);
    for (const auto point : grid.zones[z]) masses[point] += density * area(c) / 4;
  }
  Path path{{}, true};
  for (std::uint32_t i = 0; i < around; ++i) path.points.push_back(i);
  const double side = std::hypot(grid.x[1] - grid.x[0], grid.y[1] - grid.y[0]);
  section.mass = section.axial / (side * side);
  section.rotary = section.mass * section.bending / section.axial;
  Structures structures;
  const Lining lining = add_lining({"lining", path, section, {}, false, false}, grid, structures);
  structures.add_masses(masses);

  std::vector<PrescribedMotion> motions;
  for (auto p = static_cast<std::uint32_t>(grid.x.size()) - around; p < grid.x.size(); ++p) {
    const auto u = rim(grid.x[p], grid.y[p]);
    motions.push_back({{p}, Axis::kX, u[0], constant});
    motions.push_back({{p}, Axis::kY, u[1], constant});
  }
  Continuum continuum(ZoneSet(ZoneKind::kAssumedStrain, grid, law, unweighted), masses, {},
                      std::move(motions), 1, structures);
  continuum.step({0, 1.0});  // at unit velocity: displaces the rim in the next step
  settle(continuum, 1.0, 1, 1e-14);
  std::vector<LiningForces> forces;
  for (std::uint32_t i = 0; i < around; ++i) forces.push_back(forces_at(lining, continuum.structures(), i));
  return forces;
}

}  // namespace adit::fdm::test

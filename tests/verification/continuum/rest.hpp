// Static states of test grids: by kinetic damping, as the coupler relaxes a model.
#pragma once

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include "fdm_server/solver/continuum.hpp"
#include "fdm_server/solver/relaxation.hpp"

namespace adit::fdm::test {

// Steps until the mean unbalanced force is so small a part of the mean internal force, at most max_steps.
// Returns the number of steps.
inline std::uint64_t relax(Continuum& continuum, const Grid& grid, double dt, double unbalanced_ratio,
                           std::uint64_t max_steps = 100'000) {
  Relaxation relaxation(grid, std::vector<double>(grid.zones.size(), 1.0));
  const double zones_per_point = static_cast<double>(grid.zones.size()) / static_cast<double>(grid.x.size());
  double before = 0;
  bool stop = false;
  for (std::uint64_t n = 0; n < max_steps; ++n) {
    if (stop) {
      continuum.stop();
      relaxation.slowed(0);
    }
    const protocol::Step step{n, dt, true, stop};
    continuum.step(step);
    const Unrest unrest = relaxation.measure(continuum, step.kick());
    if (n > 0 && unrest.unbalanced_force * zones_per_point <= unbalanced_ratio * unrest.internal_force)
      return n;
    const double kinetic = kinetic_energy(continuum);
    stop = kinetic < before;
    before = stop ? 0 : kinetic;
  }
  return max_steps;
}

inline double none(double /*t*/) {
  return 0;
}
inline double always(double /*t*/) {
  return 1;
}

// Both components of these points stay where they are.
inline std::vector<PrescribedMotion> held(const std::vector<std::uint32_t>& points) {
  return {{points, Axis::kX, 0, none}, {points, Axis::kY, 0, none}};
}

// Unstressed zones strained by the displacements u + i v of all points.
inline ZoneSet strained_zones(ZoneKind kind, const Grid& grid, const PlaneLaw& law,
                              const std::vector<std::complex<double>>& displacements) {
  ZoneSet zones(kind, grid, law, std::vector<double>(grid.zones.size(), 1.0));
  const std::size_t n = grid.x.size();
  std::vector<double> ux(n), uy(n);
  for (std::size_t i = 0; i < n; ++i) {
    ux[i] = displacements[i].real();
    uy[i] = displacements[i].imag();
  }
  zones.follow(ux.data(), uy.data());
  zones.start_over();
  return zones;
}

// The forces of a surface traction on the points of a line that has the ground on its left, each segment's
// shared by its ends with linear shape functions (Simpson's rule).
using StressField = std::function<Stress(double x, double y)>;
inline Load traction(const Grid& grid, const std::vector<std::uint32_t>& line, const StressField& stress) {
  Load load{line, std::vector<double>(line.size(), 0.0), std::vector<double>(line.size(), 0.0), always};
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double xa = grid.x[line[i]], ya = grid.y[line[i]];
    const double dx = grid.x[line[i + 1]] - xa, dy = grid.y[line[i + 1]] - ya;
    for (const auto& [at, rule] : {std::pair{0.0, 1.0 / 6}, {0.5, 4.0 / 6}, {1.0, 1.0 / 6}}) {
      const Stress s = stress(xa + at * dx, ya + at * dy);
      const double fx = rule * (s.xx * dy - s.xy * dx), fy = rule * (s.xy * dy - s.yy * dx);
      load.fx[i] += (1 - at) * fx;
      load.fy[i] += (1 - at) * fy;
      load.fx[i + 1] += at * fx;
      load.fy[i + 1] += at * fy;
    }
  }
  return load;
}

// A ring about the origin, zones growing outwards in proportion to the radius; points of the innermost circle
// first, each circle counter-clockwise from the x axis.
struct Ring {
  double inner, outer;  // [m]
  std::uint32_t around, across;

  Grid grid() const {
    Grid grid;
    for (std::uint32_t j = 0; j <= across; ++j) {
      const double r = inner * std::pow(outer / inner, static_cast<double>(j) / across);
      for (std::uint32_t i = 0; i < around; ++i) {
        grid.x.push_back(r * std::cos(2 * std::numbers::pi * i / around));
        grid.y.push_back(r * std::sin(2 * std::numbers::pi * i / around));
      }
    }
    for (std::uint32_t j = 0; j < across; ++j)
      for (std::uint32_t i = 0; i < around; ++i) {
        const auto point = [&](std::uint32_t row, std::uint32_t column) {
          return static_cast<std::int32_t>(row * around + column % around);
        };
        grid.zones.push_back({point(j, i), point(j + 1, i), point(j + 1, i + 1), point(j, i + 1)});
      }
    return grid;
  }
  std::vector<std::uint32_t> circle(std::uint32_t number) const {
    std::vector<std::uint32_t> points(around);
    for (std::uint32_t i = 0; i < around; ++i) points[i] = number * around + i;
    return points;
  }
};

}  // namespace adit::fdm::test

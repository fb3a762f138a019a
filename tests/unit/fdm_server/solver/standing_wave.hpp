// A standing P wave in a box with rollers on all sides, u = grad phi sin(w t), phi = a cos(k x) cos(l y):
// every component of stress and strain takes part.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "fdm_server/solver/continuum.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"

namespace adit::fdm::test {

struct StandingWave {
  static constexpr double kWidth = 3, kHeight = 2, kAmplitude = 1e-4;  // of phi [m^2]
  static constexpr double k = std::numbers::pi / kWidth, l = 2 * std::numbers::pi / kHeight;
  PlaneLaw law = plane_strain(kYoung, kPoisson);
  double w = std::sqrt((law.bulk + law.shear) / kDensity * (k * k + l * l));

  struct State {
    double ux, uy, vx, vy, ax, ay, sxx, syy, sxy, exx, eyy, gxy;
  };
  State at(double x, double y, double t) const {
    const double s = kAmplitude * std::sin(w * t), c = kAmplitude * w * std::cos(w * t);
    const double gx = -k * std::sin(k * x) * std::cos(l * y), gy = -l * std::cos(k * x) * std::sin(l * y);
    const double phi = std::cos(k * x) * std::cos(l * y);
    const double exx = -k * k * phi * s, eyy = -l * l * phi * s;
    const double gxy = 2 * k * l * std::sin(k * x) * std::sin(l * y) * s;
    const double p = law.bulk * (exx + eyy), d = law.shear * (exx - eyy);
    return {gx * s,          gy * s, gx * c, gy * c, -w * w * gx * s, -w * w * gy * s, p + d, p - d,
            law.shear * gxy, exx,    eyy,    gxy};
  }

  static Block block(std::uint32_t zones_y) { return {0, kWidth, 0, kHeight, 3 * zones_y / 2, zones_y}; }

  // At step 0, with the velocities of dt / 2.
  std::unique_ptr<Continuum> start(ZoneKind kind, const Grid& grid, double dt) const {
    return start(ZoneSet(kind, grid, law, ones(grid)), grid, dt);
  }
  std::unique_ptr<Continuum> start(ZoneSet zones, const Grid& grid, double dt) const {
    std::vector<PrescribedMotion> rollers;
    for (const auto& [axis, side] :
         {std::pair{Axis::kX, 0.0}, {Axis::kX, kWidth}, {Axis::kY, 0.0}, {Axis::kY, kHeight}}) {
      PrescribedMotion roller{{}, axis, 0, [](double) { return 1; }};
      for (std::uint32_t i = 0; i < grid.x.size(); ++i)
        if ((axis == Axis::kX ? grid.x : grid.y)[i] == side) roller.points.push_back(i);
      rollers.push_back(std::move(roller));
    }
    const auto masses = lumped_masses(grid, ones(grid), kDensity);
    auto continuum =
        std::make_unique<Continuum>(std::move(zones), masses, std::vector<Load>{}, std::move(rollers));
    continuum->step({0, dt});
    for (std::uint32_t i = 0; i < grid.x.size(); ++i) {
      const State state = at(grid.x[i], grid.y[i], dt / 2);
      continuum->push(i, masses[i] * state.vx, masses[i] * state.vy);
    }
    return continuum;
  }
};

}  // namespace adit::fdm::test

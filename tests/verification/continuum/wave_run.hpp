// A smooth wave driven through a grid, beside its exact motion.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "fdm_server/solver/continuum.hpp"
#include "tests/verification/continuum/grids.hpp"
#include "tests/verification/continuum/oracles/harmonic_wave.hpp"

namespace adit::fdm::test {

using oracle::HarmonicWave;
using oracle::Medium;

// Root mean square error over the grid, relative to the same mean of the exact value.
struct Errors {
  double displacement, velocity, stress;
};

// A smooth start: 0 until t = 0, 1 from t = rise on, with three continuous derivatives.
struct Start {
  double rise;  // [s]
  double value(double t) const { return t >= rise ? 1 : polynomial({0, 0, 0, 0, 35, -84, 70, -20}, t); }
  double rate(double t) const {
    return t >= rise ? 0 : polynomial({0, 0, 0, 140, -420, 420, -140, 0}, t) / rise;
  }
  double second(double t) const {
    return t >= rise ? 0 : polynomial({0, 0, 420, -1680, 2100, -840, 0, 0}, t) / (rise * rise);
  }

 private:
  double polynomial(const std::array<double, 8>& c, double t) const {
    double sum = 0;
    for (std::size_t i = 8; i-- > 0;) sum = sum * (t / rise) + c[i];
    return sum;
  }
};

// The motion g(t) u(x, t), u the wave and g a smooth start from rest, which excites no waves that the grid
// cannot carry. The edge of the grid follows it; the surface y = 0 may be free, since g u leaves it free of
// traction as u does. The ground carries the forces rho (2 g' u' + g'' u) that the motion needs besides its
// stresses.
class WaveRun {
 public:
  WaveRun(ZoneKind kind, const Grid& grid, const HarmonicWave& wave, bool free_surface, double end,
          std::uint64_t steps)
      : grid_(grid),
        wave_(wave),
        start_{0.6 * end},
        end_(end),
        dt_(end / static_cast<double>(steps)),
        continuum_(make(kind, free_surface)) {
    for (std::uint64_t n = 0; n <= steps; ++n) continuum_.step({n, dt_});
  }

  Errors errors() const {
    Mean displacement, velocity, stress;
    for (std::size_t i = 0; i < grid_.x.size(); ++i) {
      const double x = grid_.x[i], y = grid_.y[i], m = continuum_.masses()[i];
      const auto u = wave_.displacement(x, y, end_), v = wave_.velocity(x, y, end_ + dt_ / 2);
      displacement.add(m, continuum_.ux()[i], u[0]);
      displacement.add(m, continuum_.uy()[i], u[1]);
      velocity.add(m, continuum_.vx()[i], v[0]);
      velocity.add(m, continuum_.vy()[i], v[1]);
    }
    for (std::size_t z = 0; z < grid_.zones.size(); ++z) {
      const auto c = corners(grid_, z);
      const auto [x, y] = centroid(c);
      const Stress exact = wave_.stress(x, y, end_), here = continuum_.zones().stress(z);
      stress.add(area(c), here.xx, exact.xx);
      stress.add(area(c), here.yy, exact.yy);
      stress.add(2 * area(c), here.xy, exact.xy);
    }
    return {displacement.error(), velocity.error(), stress.error()};
  }

 private:
  struct Mean {
    double squares = 0, exact = 0;
    void add(double weight, double value, double truth) {
      squares += weight * (value - truth) * (value - truth);
      exact += weight * truth * truth;
    }
    double error() const { return std::sqrt(squares / exact); }
  };

  Continuum make(ZoneKind kind, bool free_surface) const {
    const std::vector<double> ones(grid_.zones.size(), 1.0);
    const auto masses = lumped_masses(grid_, ones, wave_.medium().density);
    double left = grid_.x.back(), right = left;  // ends of the surface
    for (std::size_t i = 0; i < grid_.x.size(); ++i)
      if (grid_.y[i] == 0) {
        left = std::min(left, grid_.x[i]);
        right = std::max(right, grid_.x[i]);
      }
    std::vector<PrescribedMotion> motions;
    for (const auto i : edge_points(grid_)) {
      const double x = grid_.x[i], y = grid_.y[i];
      if (free_surface && y == 0 && x != left && x != right) continue;
      for (const std::size_t axis : {0, 1})
        motions.push_back({{i}, axis == 0 ? Axis::kX : Axis::kY, 1.0, [this, x, y, axis](double t) {
                             return start_.value(t) * wave_.velocity(x, y, t)[axis] +
                                    start_.rate(t) * wave_.displacement(x, y, t)[axis];
                           }});
    }
    // u = cos(omega t) u(0) + sin(omega t) u(quarter period)
    const double omega = wave_.omega(), quarter = std::numbers::pi / 2 / omega;
    return {ZoneSet(kind, grid_, wave_.medium().law, ones),
            masses,
            {body_force(masses, 0,
                        [=, this](double t) {
                          return start_.second(t) * std::cos(omega * t) -
                                 2 * omega * start_.rate(t) * std::sin(omega * t);
                        }),
             body_force(masses, quarter,
                        [=, this](double t) {
                          return start_.second(t) * std::sin(omega * t) +
                                 2 * omega * start_.rate(t) * std::cos(omega * t);
                        })},
            std::move(motions)};
  }

  Load body_force(std::span<const double> masses, double instant, TimeFactor factor) const {
    Load load{{}, {}, {}, std::move(factor)};
    for (std::uint32_t i = 0; i < masses.size(); ++i) {
      const auto u = wave_.displacement(grid_.x[i], grid_.y[i], instant);
      load.points.push_back(i);
      load.fx.push_back(masses[i] * u[0]);
      load.fy.push_back(masses[i] * u[1]);
    }
    return load;
  }

  const Grid& grid_;
  const HarmonicWave& wave_;
  Start start_;
  double end_, dt_;
  Continuum continuum_;
};

}  // namespace adit::fdm::test

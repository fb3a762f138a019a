// Small models of discs, made by hand.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "dem_server/engines/general/critical_step.hpp"
#include "dem_server/engines/general/solver.hpp"

namespace adit::dem::test {

inline constexpr double kSolidDensity = 2000;

// Discs of the given places and radii, solid cylinders, one group, with this contact law and nothing joined.
inline Model loose_discs(const std::vector<std::array<double, 3>>& discs, const LinearContact& contact) {
  Model model;
  for (const auto& [x, y, radius] : discs) {
    model.discs.x.push_back(x);
    model.discs.y.push_back(y);
    model.discs.radius.push_back(radius);
    model.mass.push_back(kSolidDensity * std::numbers::pi * radius * radius);
    model.weight.push_back(1);
    model.id.push_back(static_cast<std::uint32_t>(model.id.size()));
  }
  model.group.assign(discs.size(), 0);
  model.group_names = {""};
  model.density = {kSolidDensity};
  model.contacts = {contact};
  return model;
}

// Joins all pairs that touch by the model's first law of this kind.
inline void join(Model& model, Bond::Law law) {
  for (const Pair& pair : pairs_within(model.discs, 1e-9))
    model.bonds.push_back({pair.first, pair.second, law, 0});
}

inline Loads no_loads;

// All discs are accelerated by this [m/s^2].
inline void add_gravity(Model& model, double y) {
  std::vector<std::uint32_t> all(model.discs.size());
  std::iota(all.begin(), all.end(), 0u);
  model.loads.push_back({Load::Kind::kAcceleration, all, 0, y, [](double) { return 1.0; }, "body_loads"});
}

inline double always(double) {
  return 1;
}

inline MovingWall wall(double x_1, double y_1, double x_2, double y_2, const LinearContact& contact,
                       double vx = 0, double vy = 0) {
  return {"wall", x_1, y_1, x_2, y_2, contact, vx, vy, always};
}

// Runs a solver without loads and motions. Numbers start at 1: no step is from rest, velocities are those of
// -1/2.
struct Run {
  Solver solver;
  double dt;
  std::uint64_t next = 1;
  Loads loads;
  PrescribedMotions motions;
  std::vector<double> before_x, before_y, before_spin;

  Run(const Model& model, double dt, std::size_t threads = 1) : solver(model, threads), dt(dt) {}
  void step() {
    const Particles& p = solver.particles();
    before_x = p.vx;
    before_y = p.vy;
    before_spin = p.spin;
    solver.step({next++, dt}, loads, motions);
  }
  void steps(int count) {
    for (int n = 0; n < count; ++n) step();
  }
  double kinetic() const {
    const Particles& p = solver.particles();
    double twice = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
      twice += p.mass[i] * (before_x[i] * p.vx[i] + before_y[i] * p.vy[i]) +
               p.inertia[i] * before_spin[i] * p.spin[i];
    return twice / 2;
  }
};

}  // namespace adit::dem::test

// Two surfaces that touch: springs, Coulomb friction, dashpots (Cundall & Strack 1979, Geotechnique 29, 47).
//
// Normal: the spring kn gap, and the dashpot c stretch_rate, c = 2 beta sqrt(m* kn); together they never
// pull. Shear: the spring's force grows by ks dt slip_rate and slides at mu |spring's normal force|; the
// dashpot acts only while it sticks.
//
// A dashpot needs the rate at n, but velocities stand at n - 1/2. For the pair alone the rate at n is
// r - dt F / 2 m*, hence F = (spring + c r) / (1 + c dt / 2 m*): second order, and stable for any c.
#pragma once

#include <algorithm>
#include <cmath>

#include "dem_server/laws/encounter.hpp"

namespace adit::dem {

struct LinearContact {
  double normal_stiffness, shear_stiffness;      // [N/m]
  double friction;                               // coefficient
  double normal_damping = 0, shear_damping = 0;  // beta, shares of the critical damping of the pair
  bool operator==(const LinearContact&) const = default;
};

struct LinearContactState {
  double shear_force = 0;  // of the spring [N]
  bool slides = false;
};

struct ContactWork {
  double friction = 0, dashpots = 0;  // dissipated in this step, to first order [J]
};

inline Pull pull(const LinearContact& law, const Encounter& e, double dt, LinearContactState& state,
                 ContactWork* work = nullptr) {
  if (!(e.gap < 0)) {
    state = {};
    return {0, 0, 0};
  }
  const auto with_dashpot = [dt](double spring, double stiffness, double beta, double mass, double rate) {
    const double c = 2 * beta * std::sqrt(mass * stiffness);
    return (spring + c * rate) / (1 + c * dt / (2 * mass));
  };
  const double spring = law.normal_stiffness * e.gap;
  const double normal = std::min(
      0.0, with_dashpot(spring, law.normal_stiffness, law.normal_damping, e.normal_mass, e.stretch_rate));
  const double trial = state.shear_force + law.shear_stiffness * dt * e.slip_rate;
  const double limit = -law.friction * spring;
  state.slides = std::abs(trial) > limit;
  const double elastic = state.slides ? std::copysign(limit, trial) : trial;
  const double shear =
      state.slides ? elastic
                   : with_dashpot(elastic, law.shear_stiffness, law.shear_damping, e.shear_mass, e.slip_rate);
  if (work) {
    if (law.shear_stiffness > 0)
      work->friction = 0.5 * (elastic + state.shear_force) * (trial - elastic) / law.shear_stiffness;
    work->dashpots = dt * ((normal - spring) * e.stretch_rate + (shear - elastic) * e.slip_rate);
  }
  state.shear_force = elastic;
  return {normal, shear, 0};
}

}  // namespace adit::dem

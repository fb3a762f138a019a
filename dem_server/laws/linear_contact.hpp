// Two surfaces that touch: springs, Coulomb friction, dashpots (Cundall & Strack 1979, Geotechnique 29, 47).
//
// Normal: the spring kn gap where the gap is negative, and the dashpot c stretch_rate, c = 2 beta sqrt(m*
// kn); together they never pull. Shear: the spring's force grows by ks dt slip_rate and slides at mu
// |spring's normal force|; the dashpot acts only while it sticks.
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>

#include "dem_server/laws/pair_kinematics.hpp"

namespace adit::dem {

struct LinearContact {
  double normal_stiffness, shear_stiffness;      // [N/m]
  double friction;                               // coefficient
  double normal_damping = 0, shear_damping = 0;  // beta, shares of the critical damping of the pair
  auto operator<=>(const LinearContact&) const = default;
};

inline LinearContact without_dashpots(LinearContact law) {
  law.normal_damping = law.shear_damping = 0;
  return law;
}

// The normal spring's force [N].
inline double contact_normal_force(double stiffness, double gap) {
  return stiffness * std::min(gap, 0.0);
}

// The springs' forces [N]. `trial` is the shear force if the contact stuck: it sticks where shear == trial.
struct ContactSprings {
  double normal, shear, trial;
};
inline ContactSprings contact_springs(const LinearContact& law, double gap, double slip_rate, double dt,
                                      double shear_before) {
  const double normal = contact_normal_force(law.normal_stiffness, gap), limit = -law.friction * normal;
  const double trial = shear_before + law.shear_stiffness * dt * slip_rate;
  return {normal, std::min(std::max(trial, -limit), limit), trial};
}

// What friction takes in the step, times the shear stiffness [N^2]: the mean shear force over the slip
// (trial - shear) / ks, to first order.
inline double stiffness_times_friction_work(const ContactSprings& now, double shear_before) {
  return 0.5 * (now.shear + shear_before) * (now.trial - now.shear);
}

// 1 / m* of the masses that resist stretching and slipping [1/kg].
inline double inverse_slip_mass(double inverse_mass, const Arms& arms, double inverse_inertia_1,
                                double inverse_inertia_2) {
  return inverse_mass +
         (arms.first * arms.first * inverse_inertia_1 + arms.second * arms.second * inverse_inertia_2);
}

// Spring and dashpot together. A dashpot needs the rate at n, but velocities stand at n - 1/2. For the pair
// alone the rate at n is r - dt F / 2 m*, hence F = (spring + c r) / (1 + c dt / 2 m*): second order, and
// stable for any c.
inline double with_dashpot(double spring, double stiffness, double beta, double inverse_mass, double rate,
                           double dt) {
  const double mass = 1 / inverse_mass, c = 2 * beta * std::sqrt(mass * stiffness);
  return (spring + c * rate) / (1 + c * dt / (2 * mass));
}

// Forces of springs and dashpots together [N], where the surfaces touch or not.
struct ContactForces {
  double normal, shear;
};
inline ContactForces with_dashpots(const LinearContact& law, const ContactSprings& springs, bool touches,
                                   double inverse_mass_n, double inverse_mass_t, double stretch_rate,
                                   double slip_rate, double dt) {
  const bool sticks = touches && springs.trial == springs.shear;
  const double normal = std::min(0.0, with_dashpot(springs.normal, law.normal_stiffness, law.normal_damping,
                                                   inverse_mass_n, stretch_rate, dt));
  const double shear =
      with_dashpot(springs.shear, law.shear_stiffness, law.shear_damping, inverse_mass_t, slip_rate, dt);
  return {touches ? normal : springs.normal, sticks ? shear : springs.shear};
}

// What dashpots take in a step, by the trapezoid of their forces before and now [J].
inline double dashpot_work(double dt, const ContactForces& before, const ContactForces& now,
                           double stretch_rate, double slip_rate) {
  return 0.5 * dt * ((now.normal + before.normal) * stretch_rate + (now.shear + before.shear) * slip_rate);
}

}  // namespace adit::dem

// Two bodies as the laws of contacts see them.
//
// n is the unit vector from the first to the second centre, t its left normal. A law gives the pull of the
// pair, normal force N and shear force S, and the moment M that the first feels and the second resists:
//   first:  + N n + S t, moment  S arm_1 + M,     second:  - N n - S t, moment  S arm_2 - M.
// The arms add up to the distance, so that linear and angular momentum are kept to rounding, and the power of
// the pair is -(N stretch_rate + S slip_rate + M turn_rate). Tension is positive.
#pragma once

#include <cmath>

namespace adit::dem {

struct Body {
  double x, y, vx, vy, spin, radius;     // [m], [m/s], [rad/s]
  double inverse_mass, inverse_inertia;  // [1/kg], [1/(kg m^2)], 0: does not yield
};

struct Encounter {
  double nx, ny, length;  // unit normal, distance of the centres [m]
  double gap;             // between the surfaces, negative where they overlap [m]
  double arm_1, arm_2;    // from the centres to where the bodies meet [m]
  // Of the second against the first [m/s], [m/s], [rad/s]. Velocities are those that led here: they slip by
  // the length in the middle of the step, so that forces that grow by them are of second order.
  double stretch_rate, slip_rate, turn_rate;
  double normal_mass, shear_mass;  // that resist stretching and slipping [kg]
};

struct Pull {
  double normal, shear, moment;  // [N], [N], [N m]
};

namespace laws {

// Rates and masses where the normal and the arms are known, and which share of the stretch is the first
// arm's.
inline Encounter at(const Body& a, const Body& b, double nx, double ny, double length, double gap,
                    double arm_1, double arm_2, double dt, double share_1) {
  const double vx = b.vx - a.vx, vy = b.vy - a.vy, stretch_rate = vx * nx + vy * ny;
  const double half = 0.5 * dt * stretch_rate, middle_1 = arm_1 - share_1 * half,
               middle_2 = arm_2 - (1 - share_1) * half;
  const double by_mass = a.inverse_mass + b.inverse_mass;
  const double by_spin = arm_1 * arm_1 * a.inverse_inertia + arm_2 * arm_2 * b.inverse_inertia;
  return {nx,
          ny,
          length,
          gap,
          arm_1,
          arm_2,
          stretch_rate,
          (vy * nx - vx * ny) * (1 + half / length) - (middle_1 * a.spin + middle_2 * b.spin),
          b.spin - a.spin,
          1 / by_mass,
          1 / (by_mass + by_spin)};
}

}  // namespace laws

// Two discs, dt after their velocities became what they are; they meet in the middle of their overlap or gap.
inline Encounter meet(const Body& a, const Body& b, double dt) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
  const double gap = length - a.radius - b.radius;
  return laws::at(a, b, dx / length, dy / length, length, gap, a.radius + gap / 2, b.radius + gap / 2, dt,
                  0.5);
}

// A straight wall through (x, y) that moves with a velocity; (nx, ny) points into it.
struct Wall {
  double x, y, nx, ny, vx, vy;
};

// A disc and a wall, as a second body that does not yield; they meet on the wall.
inline Encounter meet(const Body& a, const Wall& wall, double dt) {
  const double distance = (wall.x - a.x) * wall.nx + (wall.y - a.y) * wall.ny;
  const Body second{0, 0, wall.vx, wall.vy, 0, 0, 0, 0};
  return laws::at(a, second, wall.nx, wall.ny, distance, distance - a.radius, distance, 0, dt, 1);
}

}  // namespace adit::dem

// Two bodies at absolute places under the laws, as a kernel applies them.
#pragma once

#include <cmath>

#include "dem_server/laws/bond_state.hpp"
#include "dem_server/laws/linear_contact.hpp"
#include "dem_server/laws/pair_kinematics.hpp"
#include "dem_server/laws/parallel_bond.hpp"

namespace adit::dem::test {

struct Body {
  double x, y, vx, vy, spin, radius;
  double inverse_mass, inverse_inertia;  // 0: does not yield
};

// A straight wall through (x, y) that moves; (nx, ny) points into it.
struct Wall {
  double x, y, nx, ny, vx, vy;
};

inline PairKinematics kinematics(const Body& a, const Body& b, const PairShape& shape, const Arms& arms,
                                 double share_1, double dt) {
  const double vx = b.vx - a.vx, vy = b.vy - a.vy, stretch = along(shape.nx, shape.ny, vx, vy);
  const double half = dt / 2 * stretch;
  const double slip = mid_step_slip_rate(across(shape.nx, shape.ny, vx, vy), half, half / shape.length, arms,
                                         share_1, a.spin, b.spin);
  return {shape.nx,    shape.ny, shape.length, shape.elongation, arms.first,
          arms.second, stretch,  slip,         b.spin - a.spin};
}

// Velocities have led here in the step dt; the elongation is the gap.
inline PairKinematics meet(const Body& a, const Body& b, double dt) {
  const PairShape shape = contact_shape<Division::kEach>(b.x - a.x, b.y - a.y, a.radius + b.radius, 0, 0);
  return kinematics(a, b, shape, arms_of(shape.length, (a.radius - b.radius) / 2), 0.5, dt);
}
inline PairKinematics meet(const Body& a, const Wall& wall, double dt) {
  const double distance = (wall.x - a.x) * wall.nx + (wall.y - a.y) * wall.ny;
  const Body second{0, 0, wall.vx, wall.vy, 0, 0, 0, 0};
  return kinematics(a, second, {wall.nx, wall.ny, distance, 1 / distance, distance - a.radius}, {distance, 0},
                    1, dt);
}

// Springs and dashpots of a contact; `shear` is its spring's force.
inline PairForces forces(const LinearContact& law, const PairKinematics& pair, const Body& a, const Body& b,
                         double dt, double& shear) {
  if (!(pair.elongation < 0)) {
    shear = 0;
    return {0, 0, 0};
  }
  const ContactSprings springs = contact_springs(law, pair.elongation, pair.slip_rate, dt, shear);
  const double inverse_mass = a.inverse_mass + b.inverse_mass;
  const ContactForces f = with_dashpots(
      law, springs, true, inverse_mass,
      inverse_slip_mass(inverse_mass, {pair.arm_1, pair.arm_2}, a.inverse_inertia, b.inverse_inertia),
      pair.stretch_rate, pair.slip_rate, dt);
  shear = springs.shear;
  return {f.normal, f.shear, 0};
}

struct BondedPair {
  double rest_length;            // [m]
  double shear = 0, moment = 0;  // [N], [N m]
  BondState state = BondState::kIntact;
};

// A parallel bond until it breaks.
inline PairForces forces(const ParallelBond& law, PairKinematics pair, double dt, BondedPair& bond) {
  if (bond.state != BondState::kIntact) return {0, 0, 0};
  pair.elongation = pair.length - bond.rest_length;
  const double width = law.area();
  const BondSprings springs =
      springs_of_width(law.normal_stiffness, law.shear_stiffness, law.moment_stiffness(), width);
  const PairForces f = bond_forces(springs, pair, dt, bond.shear, bond.moment);
  if (breaks_in_tension(f, width, ParallelBond::kMomentFactor, law.tensile_strength))
    bond.state = BondState::kTensileCrack;
  else if (breaks_in_shear(f, width, law.cohesion, law.tan_friction_angle))
    bond.state = BondState::kShearCrack;
  if (bond.state != BondState::kIntact) {
    bond.shear = bond.moment = 0;
    return {0, 0, 0};
  }
  bond.shear = f.shear;
  bond.moment = f.moment;
  return f;
}

}  // namespace adit::dem::test

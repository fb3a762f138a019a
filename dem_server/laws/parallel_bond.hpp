// A parallel bond: a strip of cement between two discs that transmits tension, shear and a moment (Potyondy &
// Cundall 2004, Int. J. Rock Mech. Min. Sci. 41, 1329), per metre of thickness.
//
// The strip is w wide: area A = w, second moment I = w^3 / 12. Its springs are spread over the area, kn and
// ks per metre [Pa/m]:
//   N = kn w (L - L0) + N0,    S += ks w dt slip_rate,    M += km w^3 dt turn_rate,    km = kn / 12.
// It breaks in tension where the largest tension in it, N / A + |M| (w / 2) / I, exceeds its tensile
// strength; times w^2 this is N w + b |M| > w^2 tensile_strength with the moment factor b = 6. Else it breaks
// in shear where |S| exceeds w cohesion - N tan(friction angle).
//
// A contact bond (contact_bond.hpp) is the case w = 1, km = b = 0 and no friction angle, its stiffnesses in
// N/m and its strengths in N.
#pragma once

#include <cmath>

#include "dem_server/laws/contact_bond.hpp"
#include "dem_server/laws/pair_kinematics.hpp"

namespace adit::dem {

struct ParallelBond {
  double normal_stiffness, shear_stiffness;  // [Pa/m]
  double radius;                             // half the width [m]
  double tensile_strength, cohesion;         // [Pa]
  double tan_friction_angle;
  static constexpr double kMomentFactor = 6;  // b
  double area() const { return 2 * radius; }
  double second_moment() const { return 2 * radius * radius * radius / 3; }
  double moment_stiffness() const { return normal_stiffness / 12; }  // km [Pa/m]
};

// The springs of a bond of a width [N/m], [N/m], [N m].
struct BondSprings {
  double kn = 0, ks = 0, km = 0;
};
inline BondSprings springs_of_width(double kn, double ks, double km, double width) {
  return {kn * width, ks * width, km * (width * width * width)};
}

// Forces of an intact bond without N0, from S and M before the step.
inline PairForces bond_forces(const BondSprings& springs, const PairKinematics& pair, double dt,
                              double shear_before, double moment_before) {
  return {bond_normal_force(springs.kn, pair.elongation),
          bond_shear_force(shear_before, springs.ks * dt, pair.slip_rate),
          moment_before + springs.km * dt * pair.turn_rate};
}

inline bool breaks_in_tension(const PairForces& bond, double width, double moment_factor,
                              double tensile_strength) {
  return breaks_in_tension(bond.normal * width + std::abs(bond.moment) * moment_factor,
                           tensile_strength * (width * width));
}
inline bool breaks_in_shear(const PairForces& bond, double width, double cohesion,
                            double tan_friction_angle) {
  return breaks_in_shear(bond.shear, cohesion * width - bond.normal * tan_friction_angle);
}

}  // namespace adit::dem

// A strip of cement between two discs that carries tension, shear and bending (Potyondy & Cundall 2004, Int.
// J. Rock Mech. Min. Sci. 41, 1329), per metre of thickness.
//
// The strip is 2 r wide: area A = 2 r, second moment I = 2 r^3 / 3. Its springs are spread over the area, kn
// and ks per metre [Pa/m]:
//   N = kn A (L - L0),   S += ks A dt slip_rate,   M += kn I dt turn_rate.
// It breaks where the largest tension in it, N / A + |M| r / I, exceeds its tensile strength, else where the
// shear stress |S| / A exceeds cohesion + compression tan(friction angle).
#pragma once

#include <cmath>

#include "dem_server/laws/encounter.hpp"
#include "dem_server/laws/bond_state.hpp"

namespace adit::dem {

struct ParallelBond {
  double normal_stiffness, shear_stiffness;  // [Pa/m]
  double radius;                             // half the width [m]
  double tensile_strength, cohesion;         // [Pa]
  double tan_friction_angle;
  double area() const { return 2 * radius; }
  double second_moment() const { return 2 * radius * radius * radius / 3; }
};

struct ParallelBondState {
  double rest_length;            // [m]
  double shear = 0, moment = 0;  // [N], [N m]
  BondState state = BondState::kIntact;
};

inline Pull pull(const ParallelBond& bond, const Encounter& e, double dt, ParallelBondState& s) {
  if (s.state != BondState::kIntact) return {0, 0, 0};
  const double area = bond.area(), second_moment = bond.second_moment();
  const double normal = bond.normal_stiffness * area * (e.length - s.rest_length);
  s.shear += bond.shear_stiffness * area * dt * e.slip_rate;
  s.moment += bond.normal_stiffness * second_moment * dt * e.turn_rate;
  const double mean = normal / area;
  if (mean + std::abs(s.moment) * bond.radius / second_moment > bond.tensile_strength)
    s.state = BondState::kTensileCrack;
  else if (std::abs(s.shear) / area > bond.cohesion - mean * bond.tan_friction_angle)
    s.state = BondState::kShearCrack;
  if (s.state != BondState::kIntact) {
    s.shear = s.moment = 0;
    return {0, 0, 0};
  }
  return {normal, s.shear, s.moment};
}

// Strain energy [J].
inline double energy(const ParallelBond& bond, double normal, const ParallelBondState& s) {
  const double area = bond.area();
  return 0.5 * (normal * normal / (bond.normal_stiffness * area) +
                s.shear * s.shear / (bond.shear_stiffness * area) +
                s.moment * s.moment / (bond.normal_stiffness * bond.second_moment()));
}

}  // namespace adit::dem

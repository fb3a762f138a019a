// A contact bond: two springs at the point where two particles meet, which transmit no moment (Potyondy &
// Cundall 2004, Int. J. Rock Mech. Min. Sci. 41, 1329).
//
//   N = kn (L - L0) + N0,     S += ks dt slip_rate.
// N0 is the force at rest. The bond breaks in tension where N exceeds its tensile strength, else in shear
// where |S| exceeds its shear strength. What is left is a contact.
//
// A thin strip of a lattice needs factors on kn and on the tensile strength of some of its bonds
// (model/solid/thin_strip.hpp). The contact that such a bond leaves is as much stiffer.
#pragma once

#include <cmath>
#include <limits>

namespace adit::dem {

inline constexpr double kUnbreakable = std::numeric_limits<double>::infinity();

struct BondStiffness {
  double normal, shear;  // kn, ks [N/m]
  bool operator==(const BondStiffness&) const = default;
};

struct BondFactors {
  double stiffness = 1, strength = 1;  // of kn and of the tensile strength
  bool operator==(const BondFactors&) const = default;
};

struct ContactBond {
  BondStiffness stiffness;
  double tensile_strength = kUnbreakable, shear_strength = kUnbreakable;  // [N]
  BondFactors factors{};                                                  // not yet in the numbers above
  bool operator==(const ContactBond&) const = default;
};

// The law with these factors in its numbers, its own left out.
inline ContactBond scaled(const ContactBond& law, const BondFactors& factors) {
  return {{law.stiffness.normal * factors.stiffness, law.stiffness.shear},
          law.tensile_strength * factors.strength,
          law.shear_strength};
}

// N - N0 [N], of a stiffness [N/m] and an elongation [m].
inline double bond_normal_force(double stiffness, double elongation) {
  return stiffness * elongation;
}

// S [N] after a step, from that before it; `stiffness_dt` is ks dt [N s/m].
inline double bond_shear_force(double before, double stiffness_dt, double slip_rate) {
  return before + stiffness_dt * slip_rate;
}

// N where the bond may be broken: then only compression remains, that of a contact. `intact` is 1 or 0.
inline double without_lost_tension(double normal, double intact) {
  return normal > 0 ? intact * normal : normal;
}

inline bool breaks_in_tension(double normal, double tensile_strength) {
  return normal > tensile_strength;
}
inline bool breaks_in_shear(double shear, double shear_strength) {
  return std::abs(shear) > shear_strength;
}

}  // namespace adit::dem

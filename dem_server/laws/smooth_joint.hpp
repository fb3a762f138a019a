// A plane of weakness through a contact, whatever the direction of the contact (Mas Ivars et al. 2011, Int.
// J. Rock Mech. Min. Sci. 48, 219): the discs slide along the plane instead of round each other.
//
// (nx, ny) is the plane's unit normal, from the first side to the second, t its left normal; u the
// displacement of the second disc against the first since the joint was made. On a piece of length A of the
// plane, springs kn and ks per metre [Pa/m] act:
//   N = kn A u.n, at most 0,     S += ks A dt slip_rate, at most mu |N|; sliding by s opens the joint by
//   |s| tan(dilation), which is taken off u.n.
// The bodies' material moves by u, and both forces act, where the bodies meet (forces/joints.hpp): spins slip
// a smooth joint too, which keeps angular momentum and energy.
#pragma once

#include <algorithm>
#include <cmath>

namespace adit::dem {

struct SmoothJoint {
  double normal_stiffness, shear_stiffness;  // [Pa/m]
  double friction;                           // coefficient
  double tan_dilation = 0;
  double length;  // A [m]
  bool operator==(const SmoothJoint&) const = default;
};

struct SmoothJointState {
  double shear = 0, opened = 0;  // [N], by dilation [m]
};

// Forces on the first disc along n and t [N].
struct JointForces {
  double normal, shear;
};

inline JointForces joint_forces(const SmoothJoint& joint, double normal_displacement, double slip_rate,
                                double dt, SmoothJointState& s) {
  const double kn = joint.normal_stiffness * joint.length, ks = joint.shear_stiffness * joint.length;
  const double normal = std::min(0.0, kn * (normal_displacement - s.opened));
  const double trial = s.shear + ks * dt * slip_rate, limit = -joint.friction * normal;
  s.shear = std::clamp(trial, -limit, limit);
  s.opened += std::abs(trial - s.shear) / ks * joint.tan_dilation;
  return {normal, s.shear};
}

}  // namespace adit::dem

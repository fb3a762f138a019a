// Pairs of discs across a smooth joint (laws/smooth_joint.hpp): they slide along its plane, which keeps its
// direction.
//
// The bodies' material moves against each other where they meet, in the middle of their gap, by
//   r = (v2 - v1) - (arm_1 w1 + arm_2 w2) t,    t the left normal of the line of centres;
// the joint's normal displacement and slip are sums of dt r along and across its normal, and its force acts
// there, on lever arms: linear and angular momentum are kept, and its power is exactly that of r.
#pragma once

#include <span>
#include <vector>

#include "dem_server/laws/smooth_joint.hpp"
#include "dem_server/particles/particles.hpp"
#include "protocol/state/archive.hpp"

namespace adit::dem {

class Joints {
 public:
  struct Joint {
    std::uint32_t first, second;
    double nx, ny;           // the plane's, from the first to the second side
    double half_difference;  // of the radii [m]
    double weight = 1;
    SmoothJoint law;
    double displacement = 0, slip = 0;  // along and across n [m]
    SmoothJointState springs{};
    double normal = 0;  // [N]
  };
  Joints() = default;
  explicit Joints(std::vector<Joint> joints) : joints_(std::move(joints)) {}

  // Adds their forces to the resultants; `dt` is 0 where the step starts from rest.
  void add_forces(double dt, Particles& particles);

  double strain_energy() const;
  double friction() const { return friction_; }  // dissipated since the start, weighted [J]
  void start_over() { friction_ = 0; }
  void replace(std::vector<Joint> joints) { joints_ = std::move(joints); }
  std::span<const Joint> joints() const { return joints_; }
  void exchange(state::Archive& archive) {
    archive.members("joints", std::span(joints_), &Joint::displacement, &Joint::slip, &Joint::springs,
                    &Joint::normal);
    archive("joint_friction", friction_);
  }

 private:
  std::vector<Joint> joints_;
  double friction_ = 0;
};

}  // namespace adit::dem

// The extremes of each joint of segments since time began.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "fdm_server/supports/joint_use.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

class PeakJoints {
 public:
  struct Instant {
    JointUse use;
    double time;  // [s]
  };
  // The instants when the opening of either face and the force of a bolt were the largest, the rotation the
  // largest by size, the tightness the least: one a joint, lining after lining; empty before the first step.
  struct Extremes {
    std::vector<Instant> opening, rotation, bolt_force, tightness;
  };

  // Takes the peaks of a step whose forces are known.
  void take(std::span<const Lining> linings, const Structures& structures, double time);
  bool empty() const { return extremes_.opening.empty(); }
  const Extremes& extremes() const { return extremes_; }

  void exchange(std::span<const Lining> linings, state::Archive& archive);

 private:
  Extremes extremes_;
};

// Calls `take` with each joint of segments and its number in the order of the extremes.
void for_each_segment_joint(std::span<const Lining> linings,
                            const std::function<void(const Lining&, const LiningJoint&, std::size_t)>& take);

}  // namespace adit::fdm

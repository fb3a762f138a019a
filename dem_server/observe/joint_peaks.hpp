// The largest slip, without sign, and the largest opening of each smooth joint over the times that are looked
// at.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "dem_server/observe/observable.hpp"
#include "protocol/state/archive.hpp"

namespace adit::dem {

class JointPeaks {
 public:
  void take(std::span<const JointForce> joints) {
    slip_.resize(joints.size(), 0.0);
    opening_.resize(joints.size(), 0.0);
    for (std::size_t k = 0; k < joints.size(); ++k) {
      slip_[k] = std::max(slip_[k], std::abs(joints[k].slip));
      opening_[k] = std::max(opening_[k], joints[k].opening);
    }
  }

  std::span<const double> slip() const { return slip_; }  // [m]; empty before anything was taken
  std::span<const double> opening() const { return opening_; }

  void exchange(std::size_t joints, state::Archive& archive) {
    archive.all_or_none("joint_peaks", {&slip_, &opening_}, joints);
  }

 private:
  std::vector<double> slip_, opening_;
};

}  // namespace adit::dem

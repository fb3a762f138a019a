// The largest thrust, moment and shear force of each node of the linings since time began, without sign.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "fdm_server/supports/lining.hpp"

namespace adit::fdm {

class PeakForces {
 public:
  // Takes the peaks of a step whose forces are known.
  void take(std::span<const Lining> linings, const Structures& structures);
  // One value a node, lining after lining: thrust [N], moment [N m], shear [N]; empty before the first step.
  const std::array<std::vector<double>, 3>& values() const { return values_; }

 private:
  std::array<std::vector<double>, 3> values_;
};

}  // namespace adit::fdm

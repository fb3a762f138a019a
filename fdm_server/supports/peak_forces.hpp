// The largest thrust, moment and shear force of each node of the linings since time began, without sign.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "fdm_server/supports/lining.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

class PeakForces {
 public:
  // Takes the peaks of a step whose forces are known.
  void take(std::span<const Lining> linings, const Structures& structures);
  // One value a node, lining after lining: thrust [N], moment [N m], shear [N]; empty before the first step.
  const std::array<std::vector<double>, 3>& values() const { return values_; }

  void exchange(std::span<const Lining> linings, state::Archive& archive) {
    archive.all_or_none("lining_peaks", {&values_[0], &values_[1], &values_[2]}, nodes_of(linings));
  }

 private:
  static std::size_t nodes_of(std::span<const Lining> linings);

  std::array<std::vector<double>, 3> values_;
};

}  // namespace adit::fdm

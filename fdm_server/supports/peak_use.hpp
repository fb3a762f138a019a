// The largest use of each node of the linings with reinforced sections since time began.
#pragma once

#include <span>
#include <vector>

#include "fdm_server/supports/section_use.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

class PeakUse {
 public:
  struct Instant {
    SectionUse use;
    double time;  // [s]
  };
  // The instants when one of these was the largest, by size, one a node, lining after lining; empty before
  // the first step. Nodes of linings without a section have no use.
  struct Extremes {
    std::vector<Instant> utilisation, shear, moment_ratio, curvature, steel_strain, crack_width,
        hinge_rotation;
  };

  // Takes the peaks of a step whose forces are known.
  void take(std::span<const Lining> linings, const Structures& structures, double time);
  bool empty() const { return largest_.utilisation.empty(); }
  const Extremes& largest() const { return largest_; }

  void exchange(std::span<const Lining> linings, state::Archive& archive);

 private:
  Extremes largest_;
};

// Whether any has one.
bool any_section(std::span<const Lining> linings);

}  // namespace adit::fdm

// The largest use of the sections of a lining whose strength is stated, over the times that are looked at.
#pragma once

#include <span>
#include <vector>

#include "dem_server/lining/sections.hpp"
#include "protocol/state/archive.hpp"

namespace adit::dem {

class UsePeaks {
 public:
  struct Instant {
    double value;  // utilisation, shear force over shear strength, or ratio of the moment
    SectionForces forces;
    double time;  // [s]
  };

  // `forces`: of all cuts at a time [s], ascending.
  void take(std::span<const Cut> cuts, std::span<const SectionForces> forces, double time);

  // One of each cut; empty before anything was taken, and where no cut has a strength. 0 of cuts without.
  std::span<const Instant> utilisation() const { return utilisation_; }
  std::span<const Instant> shear() const { return shear_; }
  std::span<const Instant> moment_ratio() const { return moment_ratio_; }

  void exchange(std::size_t cuts, state::Archive& archive) {
    archive.all_or_none("section_use", {&utilisation_, &shear_, &moment_ratio_}, cuts);
  }

 private:
  std::vector<Instant> utilisation_, shear_, moment_ratio_;
};

// 0 of a cut without a strength.
sections::Use use_of(const Cut& cut, const SectionForces& forces);
bool any_strength(std::span<const Cut> cuts);

}  // namespace adit::dem

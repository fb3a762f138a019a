// The largest forces and offsets of each dowel between rings since time began.
#pragma once

#include <vector>

#include "fdm_server/structures/structures.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

class PeakDowels {
 public:
  struct Instant {
    double size, time;  // [N] per metre of the plane, or [m]; [s]
  };

  // Takes the peaks of a step whose forces are known.
  void take(std::span<const Dowel> dowels, double time);
  // One a dowel; empty before the first step.
  const std::vector<Instant>& forces() const { return forces_; }
  const std::vector<Instant>& offsets() const { return offsets_; }

  void exchange(std::size_t dowels, state::Archive& archive);

 private:
  std::vector<Instant> forces_, offsets_;
};

}  // namespace adit::fdm

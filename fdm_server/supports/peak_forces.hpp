// The largest and the least thrust, moment and shear force of each node of the linings since time began.
#pragma once

#include <span>
#include <vector>

#include "fdm_server/supports/lining.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

class PeakForces {
 public:
  // What acts at a node at one time.
  struct Instant {
    double thrust, moment, shear;  // [N], [N m], [N], signs as in beam.hpp
    double time;                   // [s]
  };
  // The instants when one of these forces was extreme, one a node, lining after lining; empty before the
  // first step.
  struct Extremes {
    std::vector<Instant> largest, least;
  };

  // Takes the peaks of a step whose forces are known.
  void take(std::span<const Lining> linings, const Structures& structures, double time);
  bool empty() const { return thrust_.largest.empty(); }
  const Extremes& thrust() const { return thrust_; }
  const Extremes& moment() const { return moment_; }
  const Extremes& shear() const { return shear_; }

  void exchange(std::span<const Lining> linings, state::Archive& archive);

 private:
  Extremes thrust_, moment_, shear_;
};

}  // namespace adit::fdm

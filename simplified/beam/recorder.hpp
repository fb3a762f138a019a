// Collects the results of a run step by step.
#pragma once

#include <vector>

#include "simplified/beam/run.hpp"
#include "simplified/beam/stepper.hpp"

namespace adit::simplified::beam {

class Recorder {
 public:
  // Throws UserError if a station lies outside the tunnel.
  Recorder(const Stepper& stepper, const RunOptions& options, Results& results);
  void record(long step);  // records the present state of the stepper
  void finish();           // adds energy error and counts

 private:
  void update_envelopes(double time);
  void update_joints(double time);
  Record snapshot(double time, std::span<const std::size_t> elements) const;

  const Stepper& stepper_;
  const RunOptions& options_;
  Results& results_;
  std::vector<SectionForces> forces_;           // present forces, by element
  std::vector<std::size_t> all_, at_stations_;  // elements
  double largest_error_ = 0, largest_energy_ = 0;
};

}  // namespace adit::simplified::beam

// How far a model is from rest while it relaxes, and whether it still comes nearer.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "coupler/participants/participant.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/state/archive.hpp"

namespace adit::coupler {

// All participants together: kinetic energy of the step predicted last, forces of the step before.
struct Unrest {
  double kinetic_energy = 0;                        // [J]
  double unbalanced_force = 0, internal_force = 0;  // sums [N]
  std::uint64_t points = 0, elements = 0;
  double largest = 0, x = 0, y = 0;                     // unbalanced force of a point [N], its place [m]
  std::string largest_of;                               // the participant that has it
  double net_x = 0, net_y = 0, drag_x = 0, drag_y = 0;  // see wire.proto, Relaxation

  explicit Unrest(std::vector<Participant>& participants);

  // Mean unbalanced force of all points, and the largest one, over the mean internal force of all zones and
  // bonds: that of now, or of the beginning where it was larger, because ground that is free to expand has
  // none left in the end.
  double mean_ratio(double internal_at_first) const;
  double largest_ratio(double internal_at_first) const;

  // The velocity at which the model would go on, were it released as it is: where the dashpots balance what
  // the free points lack of equilibrium together. 0 where something holds the model, or no dashpots are
  // there.
  protocol::Drift drift() const;

 private:
  double mean_internal_force(double internal_at_first) const;
};

// Notices that the ratio does not fall any more. The smallest ratios of the last half of the steps and of the
// quarter before give the rate at which it falls; it stalls where this rate would not do within the steps
// that are allowed. A model that goes on converging as fast as it does is never stopped.
class Stall {
 public:
  Stall(double wanted, std::uint64_t max_steps) : wanted_(wanted), max_steps_(max_steps) {}
  // To be called with the ratio of every step.
  bool noticed(double ratio);
  void exchange(state::Archive& archive) {
    archive("stall_smallest", smallest_);
    archive("stall_steps", steps_);
  }

 private:
  static constexpr std::uint64_t kBin = 1000, kFirstLook = 20'000;  // steps
  double wanted_;
  std::uint64_t max_steps_, steps_ = 0;
  std::vector<double> smallest_;  // ratio of each bin
};

}  // namespace adit::coupler

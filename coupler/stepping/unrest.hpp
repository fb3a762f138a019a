// How far a model is from rest while it relaxes, and whether it still comes nearer.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "coupler/participants/participant.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/state/archive.hpp"

namespace adit::coupler {

// What has moved farthest since a stage of statics began.
struct Moved {
  double distance = 0, x = 0, y = 0;  // [m], and the place that it came from [m]
  std::string of, what;               // the participant, and what of it, where it has a name
  double extent = 0;                  // of the participant, the longer side [m]
};

// All participants together: kinetic energy of the step predicted last, forces of the step before.
struct Unrest {
  double kinetic_energy = 0;                        // [J]
  double unbalanced_force = 0, internal_force = 0;  // sums [N]
  std::uint64_t points = 0, elements = 0;
  double largest = 0, x = 0, y = 0;                     // unbalanced force of a point [N], its place [m]
  std::string largest_of;                               // the participant that has it
  Moved moved;                                          // where they tell it in this step
  double net_x = 0, net_y = 0, drag_x = 0, drag_y = 0;  // see wire.proto, Relaxation

  explicit Unrest(std::vector<Participant>& participants);

  // Mean unbalanced force of all points, and the largest one, over the mean internal force of all zones and
  // bonds: that of now, or of the beginning where it was larger, because ground that is free to expand has
  // none left in the end.
  double mean_ratio(double internal_at_first) const;
  double largest_ratio(double internal_at_first) const;

  // Nothing holds what falls: the model's net force meets no reaction and exceeds all that the ground bears.
  // No internal force changes a net force, so that such a model cannot come to rest.
  bool falls(double internal_at_first) const;
  // Something may still stop what falls, such as grains above a wall.
  bool may_land() const;

  // The velocity at which the model would go on, were it released as it is: where the dashpots balance what
  // the free points lack of equilibrium together. 0 where something holds the model, or no dashpots are
  // there.
  protocol::Drift drift() const;

 private:
  double mean_internal_force(double internal_at_first) const;
  double drag_along_net() const { return std::abs(net_y) < std::abs(net_x) ? drag_x : drag_y; }
};

// Notices that a model does not come to rest, by what its steps have told so far.
//
// It stalls where the ratio does not fall any more. The smallest ratios of the last half of the steps and of
// the quarter before give the rate at which it falls; it stalls where this rate would not do within the steps
// that are allowed. A model that goes on converging as fast as it does is never stopped.
//
// It flows where something goes away. What comes to rest slows down: it moves less in the second half of the
// steps than in the first. Only the first swing of a model, of a quarter of its longest period, is as fast
// later as before; but the forces of the ground grow meanwhile with the displacement, and the ratio falls to
// a quarter whenever the steps double. Ground that has reached its strength, and a body that nothing holds,
// have no such forces. It therefore flows where the farthest point has moved by more than a twentieth of its
// model, in the second half at least as far as in the first, while the ratio has not fallen to half; and
// where it moves so by more than the whole model, whatever the ratio, which falls also because flowing ground
// squeezes what stands.
class Stall {
 public:
  enum Kind { kGoesOn, kStalls, kFlows };
  Stall(double wanted, std::uint64_t max_steps) : wanted_(wanted), max_steps_(max_steps) {}
  // To be called with the ratio of every step, and what has moved farthest as far as is known.
  Kind noticed(double ratio, const Moved& moved = {});
  void exchange(state::Archive& archive) {
    archive("stall_smallest", smallest_);
    archive("stall_moved", moved_);
    archive("stall_steps", steps_);
  }

 private:
  bool stalls() const;
  bool flows(const Moved& moved) const;
  static constexpr std::uint64_t kBin = 1000, kFirstLook = 20'000, kFirstLookAtFlow = 10'000;  // steps
  double wanted_;
  std::uint64_t max_steps_, steps_ = 0;
  std::vector<double> smallest_;  // ratio of each bin
  std::vector<double> moved_;     // distance at its end [m]
};

}  // namespace adit::coupler

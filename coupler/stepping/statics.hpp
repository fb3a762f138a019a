// Bringing a model to rest under its loads before it is shaken.
//
// All participants step together, ties and all, near rest with masses of their own (time_step.hpp,
// choose_static_steps), which change nothing of what is at rest. Motion is taken away by one of:
// - local damping (protocol/participant/local_damping.hpp), which brakes each point by itself: the default
//   where particles may touch without bonds, whose contacts keep some points in motion long after the others
//   have come to rest;
// - kinetic damping (Cundall 1976; Barnes 1999): whenever the kinetic energy of the whole model has passed a
//   peak, all velocities are set to 0, before they move anything. A step's delay would leave the fastest
//   motions, which pass their peak every third step, undamped; and so would stops every third step those of
//   that period, so that one in eleven waits a step;
// - adaptive damping (Nesterov 1983; O'Donoghue & Candès 2015), where the scene states it: the n-th step
//   after a stop takes 3 / (3 + n) of all velocities, and all stop when the forces take kinetic energy away.
// Neither alters the constraint or the weighted overlap, so that what is at rest stays at rest when time
// begins.
//
// Steps to rest with local and with kinetic damping: excavation 8693, 2651; lined tunnel 210252, 77443; a
// patch of lattice 357, 592; a ring of segments with weak joints 19746, 7265. With open joints local damping
// takes 19451 to 1e-4 and kinetic damping stands at 7.6e-4 after 20000; a tunnel at a fault 14616 and, after
// 20000, 1.8e-4.
//
// Near rest, but for local damping, masses make one step critical for each zone, beam and bond (wire.proto,
// Advance.scale_masses): excavation 2651 -> 581, lined tunnel 77443 -> 11833. A reduced ring of segments with
// weak joints comes to 1e-5 in 110679 steps with local damping and in 3407 with adaptive damping, whose
// forces then differ by 0.3 %. States reached at the same ratio are farther from rest than without such
// masses: 8 instead of 4.5 % at 1e-3 in that ring.
//
// Quiet edges are held in statics, and go on being held by the forces of then, but for what is inertia in
// them (Unrest::drift, fdm_server/solver/dashpots.hpp).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "coupler/stepping/stepper.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/state/archive.hpp"

namespace adit::coupler {

struct Rest {
  std::uint64_t steps = 0, stops = 0;
  double mean_ratio = 0, largest_ratio = 0;  // reached, see Unrest
  double x = 0, y = 0;                       // place of the largest unbalanced force [m]
  std::string of;                            // the participant that has it
  // Velocity at which the model would have gone on, had what held its edges not been corrected.
  protocol::Drift drift;
  // Mean size of the unbalanced forces over the mean mass of a point: by how much the points are accelerated
  // when time begins [m/s^2]; 0 where a participant does not tell its mass.
  double acceleration = 0;
};

// Relaxes to the scene's `statics.unbalanced_ratio`: mean unbalanced force of all points over mean internal
// force of all zones and bonds; then again after each stage of the scene's excavations. Shows progress.
class Statics {
 public:
  Statics(Model& model, Stepper& stepper);
  ~Statics();

  // To rest, from the beginning or from the state that was read. `between_steps` is called after every step,
  // with whether a stage has come to rest by it. Throws protocol::UserError where something goes on moving,
  // or `max_steps` do not suffice, or could not at the rate of now.
  using BetweenSteps = std::function<void(bool at_rest)>;
  void run(const BetweenSteps& between_steps);
  // All stages have come to rest.
  bool done() const;
  const Rest& rest() const;
  void exchange(state::Archive& archive);

 private:
  class Relaxer;
  std::unique_ptr<Relaxer> relaxer_;
};

// All of it at once.
Rest relax(Model& model, Stepper& stepper);

}  // namespace adit::coupler

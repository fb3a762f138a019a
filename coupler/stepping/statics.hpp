// Bringing a model to rest under its loads before it is shaken.
//
// All participants step together, ties and all, without damping; whenever the kinetic energy of the whole
// model has passed a peak, all velocities are set to 0, before they move anything, and it starts again from
// where it is (kinetic damping: Cundall 1976; Barnes 1999). A step's delay would leave the fastest motions,
// which pass their peak every third step, undamped. The method needs no parameter, does not depend on the
// participants' masses, and leaves the constraint and the weighted overlap what they are in dynamics, so that
// what is at rest stays at rest when time begins.
#pragma once

#include <cstdint>

#include "coupler/stepping/stepper.hpp"

namespace adit::coupler {

struct Rest {
  std::uint64_t steps = 0, stops = 0;
  double unbalanced_ratio = 0;  // reached
};

// Relaxes to the scene's `statics.unbalanced_ratio`: mean unbalanced force of all points over mean internal
// force of all zones and bonds; then again after each stage of the scene's excavations. Shows progress.
// Throws protocol::Unstable where `max_steps` do not suffice.
Rest relax(Model& model, Stepper& stepper);

}  // namespace adit::coupler

// What every time scheme does with a side: ask it to advance, read its answer, know what its correction will
// do.
#pragma once

#include <vector>

#include "coupler/sides/side.hpp"

namespace adit::coupler {

// Asks the side for a step: what is the same for all sides, and its pending impulses.
void post_advance(Side& side, const wire::Advance& request);

// Collects the answer and reads the predicted velocities. An answer that does not fit what was asked is
// protocol::PeerLost.
void receive_prediction(Side& side);

// corrected = predicted + N M⁻¹ Nᵀ impulses: what the participant will apply, at the coupling points.
void correct_velocities(Side& side);

// The state at the step that each side has reached, after the correction by its pending impulses.
std::vector<wire::Snapshot> take_snapshots(std::vector<Side>& sides);

}  // namespace adit::coupler

// What every time scheme does with a participant: ask it to advance, read its answer, know what its
// correction will do.
#pragma once

#include <cstdint>
#include <vector>

#include "coupler/exchange/wanted.hpp"
#include "coupler/participants/participant.hpp"

namespace adit::coupler {

// The request for a step, as it is the same for all participants.
void fill_request(wire::Advance& request, std::uint64_t step, double dt, Wanted wanted);

// Asks the participant for this step, and sends its pending correction with it.
void post_advance(Participant& participant, const wire::Advance& request);

// Collects the answer and reads the predicted velocities. An answer that does not fit what was asked is
// protocol::PeerLost.
void receive_prediction(Participant& participant);

// corrected = predicted + N M⁻¹ Nᵀ impulses: what the participant will apply, at the coupling points.
void correct_velocities(Participant& participant);

// The state at the step that each participant has reached, after its pending correction. Pieces of a region
// carry its name. What cannot be drawn is protocol::PeerLost.
std::vector<wire::Snapshot> take_snapshots(std::vector<Participant>& participants);

}  // namespace adit::coupler

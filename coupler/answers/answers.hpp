// What a participant says, looked at when it arrives. Participants are other programs: an answer that no
// correct one gives ends the run with the name of the one that gave it, before anything computes with it.
//
// Here is what holds whatever was asked; whether an answer fits its request is looked at by those who asked
// (interface.cpp, operator.cpp, round_trip.cpp).
#pragma once

#include <string>

#include "protocol/messages/wire.pb.h"

namespace adit::coupler {

// Throws protocol::PeerLost, which names `peer` and what is wrong.
void require_sound(const wire::Frame& frame, const std::string& peer);

}  // namespace adit::coupler

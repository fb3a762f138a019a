// A session of a server, without its socket.
#pragma once

#include <vector>

#include "protocol/messages/wire.pb.h"
#include "protocol/participant/participant.hpp"

namespace adit::fuzz {

// Hands the requests to the participant until it refuses one, which must be for a reason that it can tell.
// Returns whether it refused none.
bool serve(protocol::Participant& participant, const std::vector<wire::Frame>& requests);

}  // namespace adit::fuzz

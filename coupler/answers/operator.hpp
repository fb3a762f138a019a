// How a participant says that it follows its coupling points (wire.proto, Operator).
#pragma once

#include <cstddef>
#include <string>

#include "coupler/bridging/interpolation.hpp"
#include "protocol/messages/wire.pb.h"

namespace adit::coupler {

// Throws protocol::PeerLost where the operator cannot be used.
Interpolation interpolation_of(const wire::Operator& op, std::size_t coupling_points,
                               const std::string& peer);

}  // namespace adit::coupler

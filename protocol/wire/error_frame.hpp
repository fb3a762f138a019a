// How errors travel: the exception of one end becomes a wire::Error and is thrown again at the other.
//   SCENE <-> UserError     UNSTABLE <-> Unstable     REQUEST <-> RequestError
//   INTERNAL: any other exception -> PeerLost         REFUSED -> UserError without a path, naming the peer
#pragma once

#include <exception>
#include <string>

#include "protocol/errors.hpp"
#include "protocol/messages/wire.pb.h"

namespace adit::protocol {

void fill_error(const std::exception& cause, wire::Error& error);

// Throws what `error` says, which `peer` sent.
[[noreturn]] void throw_error(const std::string& peer, const wire::Error& error);

}  // namespace adit::protocol

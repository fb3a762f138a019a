// Sends exceptions from one end to the other: as a wire::Error, which the other end throws again.
//   SCENE     UserError at both ends
//   UNSTABLE  Unstable at both ends
//   REQUEST   RequestError at both ends
//   INTERNAL  any other exception here, PeerLost there
//   REFUSED   sent by a busy server; UserError there, without a path, naming the server
#pragma once

#include <exception>
#include <string>

#include "protocol/errors.hpp"
#include "protocol/messages/wire.pb.h"

namespace adit::protocol {

void fill_error(const std::exception& cause, wire::Error& error);

// Throws the exception that stands for `error`, which `peer` sent.
[[noreturn]] void throw_error(const std::string& peer, const wire::Error& error);

}  // namespace adit::protocol

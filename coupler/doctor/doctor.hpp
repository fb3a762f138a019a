// What a server is like that already listens: whether it can be reached and serves this user, who it is, and
// how fast it answers.
#pragma once

#include <cstddef>
#include <string>

#include "coupler/servers/join.hpp"

namespace adit::coupler {

// Prints a line for each finding. A server that does not serve throws protocol::UserError or
// protocol::PeerLost, which say why, after the lines until there. `points`: coupling points of the model
// whose steps are timed.
void doctor(const std::string& address, const TrustFiles& trust, std::size_t points);

}  // namespace adit::coupler

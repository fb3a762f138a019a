// Runs servers against a recording: each is asked what the recorded one was asked, and its answers are
// compared with the recorded ones, bit by bit.
#pragma once

#include <filesystem>
#include <string>

#include "coupler/servers/join.hpp"

namespace adit::coupler {

// Replays the models whose servers `choice` names; where it names none, every model, or `only` this one, by
// servers that are started here. One server runs at a time, up to its first difference. Prints what was
// found and returns the exit code. Throws protocol::UserError for a recording that cannot be read or has no
// such model, protocol::PeerLost for a server that is lost where the recorded one was not.
int replay(const std::filesystem::path& recording, const ServerChoice& choice, const std::string& only);

}  // namespace adit::coupler

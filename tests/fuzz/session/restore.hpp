// A participant that goes on from a state that a client hands to it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "protocol/participant/participant.hpp"

namespace adit::fuzz {

inline const std::vector<std::string> kScenesOfGround = {"block", "ground", "slipping"},
                                      kScenesOfParticles = {"lattice", "grains", "ring", "cells"};

// The first byte of the input chooses one of the scenes, the second is the step that follows; the rest is the
// state, with the checksum that it has. Returns whether the participant took it and went on.
bool go_on_from(std::string_view input, protocol::Participant& participant,
                const std::vector<std::string>& scenes);

}  // namespace adit::fuzz

// The small scenes of tests/fuzz/scenes, and what a coupler asks a participant before the first step.
#pragma once

#include <string>
#include <vector>

#include "protocol/messages/wire.pb.h"

namespace adit::fuzz {

scene::Scene small_scene(const std::string& name);

// Setup and weights of a participant that is not coupled.
const std::vector<wire::Frame>& beginning(const std::string& scene);

// The step n in time, with all that can be asked of it.
wire::Frame advance_to(std::uint64_t n);

}  // namespace adit::fuzz

// A session as an input: frames in protobuf's text format, divided by lines `---`. Text keeps its structure
// where bytes of it are changed, and a person can read it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "protocol/messages/wire.pb.h"

namespace adit::fuzz {

// The frames as they arrive (arrival.hpp). Pieces that are no frame are left out.
std::vector<wire::Frame> frames_of(std::string_view script);

std::string script_of(const std::vector<wire::Frame>& frames);

// Whether the model of the scene is small enough to be computed some thousand times a second. A client that
// is let in may ask for one of hours.
bool is_small(const scene::Scene& scene);

}  // namespace adit::fuzz

// A frame on its way from one end to the other.
#pragma once

#include <optional>
#include <string_view>

#include "protocol/messages/wire.pb.h"

namespace adit::fuzz {

// The frame of these bytes, as a connection hands it on: short or long, readable, with clean texts. Nothing
// where they are no frame.
std::optional<wire::Frame> arrived(std::string_view payload);

}  // namespace adit::fuzz

// Reads the file of a study: YAML whose keys, types, units, limits and defaults are those of study.proto.
#pragma once

#include <string>

#include "protocol/messages/study.pb.h"

namespace adit::protocol {

// Throws UserError with an empty path() whose what() is one complete line, as read_scene does (reader.hpp).
study::Study read_study(const std::string& path);

}  // namespace adit::protocol

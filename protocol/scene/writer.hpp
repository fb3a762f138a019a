// A scene as YAML that reads back to the same message: what was really computed, after bases and overrides.
#pragma once

#include <string>

#include "protocol/messages/scene.pb.h"

namespace adit::protocol {

// Only the fields that are set, without `base`; numbers are bare, which means SI.
std::string to_yaml(const scene::Scene& scene);

}  // namespace adit::protocol

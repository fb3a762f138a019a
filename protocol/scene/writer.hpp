// A scene, or a study, as YAML that reads back to the same message: what was really computed, after bases and
// overrides.
#pragma once

#include <google/protobuf/message.h>

#include <string>

namespace adit::protocol {

// Only the fields that are set, without `base`; numbers are bare, which means SI.
std::string to_yaml(const google::protobuf::Message& scene);

}  // namespace adit::protocol

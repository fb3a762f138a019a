// From a YAML tree to a message of scene.proto, by protobuf reflection: the messages themselves say which
// fields exist, of which type and unit, within which limits.
#pragma once

#include <google/protobuf/message.h>

#include <string>

#include "protocol/scene/yaml/yaml_tree.hpp"

namespace adit::protocol {

// Fills the empty `message` from `value`, which stands at `path` of the scene; what is not given stays unset.
// The first thing wrong, in the order of the text, throws UserError in one line with place and path; a
// missing field counts as being at the end of its mapping.
void read_message(const YamlValue& value, const std::string& path, google::protobuf::Message& message);

}  // namespace adit::protocol

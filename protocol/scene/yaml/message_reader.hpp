// Reads a YAML tree into a message of scene.proto by protobuf reflection: the descriptors of the messages say
// which fields exist, and their types, units and limits. All their other rules are for check_rules.hpp.
#pragma once

#include <google/protobuf/message.h>

#include <string>

#include "protocol/scene/yaml/yaml_tree.hpp"

namespace adit::protocol {

// Fills the empty `message` from `value`, which stands at `path` of the scene; fields that are not given stay
// unset. Throws UserError for the first error in the order of the text, in one line with place and path.
void read_message(const YamlValue& value, const std::string& path, google::protobuf::Message& message);

}  // namespace adit::protocol

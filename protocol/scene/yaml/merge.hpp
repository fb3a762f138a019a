// Several layers of a scene become one: a file over the file that it extends, `--set` over the file.
#pragma once

#include <google/protobuf/descriptor.h>

#include <span>
#include <string>
#include <vector>

#include "protocol/scene/yaml/yaml_tree.hpp"

namespace adit::protocol {

// Lays `from` over `into`. Mappings are merged member by member; any other value is replaced. A member of
// `from` removes the members of `into` that exclude it (a oneof of `type`); one that is null removes its own
// from `into`, where it is there to be removed. `type` is the type of the message
// that `into` describes, null if it describes none. Merged values keep the place at which they were written.
void merge(YamlValue& into, YamlValue from, const google::protobuf::Descriptor* type);

// One `--set path=value`; `value` is YAML.
struct Override {
  std::string path;
  std::string value;
};

// Splits each "path=value"; throws UserError if `=` or the path is missing.
std::vector<Override> parse_overrides(std::span<const std::string> texts);

// Replaces or adds the value at the path; `null` removes it. Missing mappings on the way are added; elements
// of lists, and what is removed, must exist. Errors name "--set path=value" as the place of the value.
void apply(const Override& set, YamlValue& root, const google::protobuf::Descriptor* type);

}  // namespace adit::protocol

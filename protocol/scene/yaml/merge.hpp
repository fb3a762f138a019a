// Several layers of a scene become one: a file over its base, `--set` over the file.
#pragma once

#include <google/protobuf/descriptor.h>

#include <span>
#include <string>
#include <vector>

#include "protocol/scene/yaml/yaml_tree.hpp"

namespace adit::protocol {

// Lays `from` over `into`: mappings member by member, anything else is replaced. Of members that exclude each
// other (a oneof of `type`) those of `from` stay. `type` is the message that `into` describes, null for none.
// Merged values keep the place at which they were written.
void merge(YamlValue& into, YamlValue from, const google::protobuf::Descriptor* type);

// One `--set path=value`; `value` is YAML.
struct Override {
  std::string path;
  std::string value;
};

// Splits each "path=value"; throws UserError where there is no `=` or no path.
std::vector<Override> parse_overrides(std::span<const std::string> texts);

// Replaces, or adds, what stands at the path; mappings on the way come into being, elements of lists must
// exist. The values stand at "--set path=value", which errors name.
void apply(const Override& set, YamlValue& root, const google::protobuf::Descriptor* type);

}  // namespace adit::protocol

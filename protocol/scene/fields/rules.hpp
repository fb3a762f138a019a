// What a scene field must be, in words: from its type, its unit and its limits in scene.proto.
#pragma once

#include <google/protobuf/descriptor.h>

#include <string>
#include <string_view>
#include <vector>

#include "protocol/messages/rule.pb.h"

namespace adit::protocol {

const scene::Rule& rule_of(const google::protobuf::FieldDescriptor* field);

// Whether the programs fill the field, so that users must not.
bool is_internal(const google::protobuf::FieldDescriptor* field);

// Names as they are written in a scene.
std::vector<std::string> field_names(const google::protobuf::Descriptor* type);
std::vector<std::string> enumerators(const google::protobuf::EnumDescriptor* type);  // in lower case
std::string join(const std::vector<std::string>& names);                             // "x, y, z"

// A value that the field accepts, as YAML on one line: "30 GPa", "{x: 0.5 m, y: 0.5 m}", "[10 ms]".
std::string example(const google::protobuf::FieldDescriptor* field);
// The same for a message: its required fields, or the one of the smallest number.
std::string example(const google::protobuf::Descriptor* type);

// What one value of the field must be: "a length above 0 m", "one of plane_strain, plane_stress".
std::string expectation(const google::protobuf::FieldDescriptor* field);

// What a number of the field is, and one value of it: "a length", "0.5 m".
std::string quantity_of(const google::protobuf::FieldDescriptor* field);
std::string in_unit(double value, const google::protobuf::FieldDescriptor* field);

// A text in a field called `name` becomes part of names of files, columns and figures, and must be fit for
// all of them: whether it is.
bool is_name_field(const google::protobuf::FieldDescriptor* field);
bool fit_for_a_name(std::string_view text);

// Whether a number lies within the limits of the rule.
bool within(const scene::Rule& rule, double value);

}  // namespace adit::protocol

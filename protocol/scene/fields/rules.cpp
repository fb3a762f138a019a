#include "protocol/scene/fields/rules.hpp"

#include <algorithm>
#include <cctype>

#include "protocol/scene/fields/quantity.hpp"
#include "protocol/text.hpp"
#include "protocol/unseen.hpp"

namespace adit::protocol {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::EnumDescriptor;
using google::protobuf::FieldDescriptor;

constexpr std::size_t kLongestName = 100;  // a file's name has room for 255 bytes

// " above 0 m and below 3 m"
std::string limits(const scene::Rule& rule) {
  std::string text;
  const auto add = [&](bool given, const char* relation, double bound) {
    if (!given) return;
    text += (text.empty() ? " " : " and ") + std::string(relation) + " " + shortest(bound);
    if (rule.has_unit()) text += " " + rule.unit();
  };
  add(rule.has_above(), "above", rule.above());
  add(rule.has_at_least(), "of at least", rule.at_least());
  add(rule.has_below(), "below", rule.below());
  add(rule.has_at_most(), "at most", rule.at_most());
  return text;
}

// The field of the smallest number: what a message held first is what it is about.
const FieldDescriptor* oldest_field(const Descriptor* type) {
  const FieldDescriptor* oldest = type->field(0);
  for (int i = 1; i < type->field_count(); ++i)
    if (type->field(i)->number() < oldest->number()) oldest = type->field(i);
  return oldest;
}

std::string example_element(const FieldDescriptor* field) {
  switch (field->cpp_type()) {
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return example(field->message_type());
    case FieldDescriptor::CPPTYPE_ENUM:
      return enumerators(field->enum_type()).front();
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return quantity_example(rule_of(field).unit());
    case FieldDescriptor::CPPTYPE_BOOL:
      return "true";
    case FieldDescriptor::CPPTYPE_STRING:
      return "some_name";
    default:
      return "10";
  }
}

}  // namespace

const scene::Rule& rule_of(const FieldDescriptor* field) {
  return field->options().GetExtension(scene::rule);
}

bool is_internal(const FieldDescriptor* field) {
  return rule_of(field).has_content_of();
}

std::vector<std::string> field_names(const Descriptor* type) {
  std::vector<std::string> names;
  for (int i = 0; i < type->field_count(); ++i)
    if (!is_internal(type->field(i))) names.push_back(type->field(i)->name());
  return names;
}

std::vector<std::string> enumerators(const EnumDescriptor* type) {
  std::vector<std::string> names;
  for (int i = 0; i < type->value_count(); ++i) names.push_back(lower_case(type->value(i)->name()));
  return names;
}

std::string join(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

std::string example(const FieldDescriptor* field) {
  if (rule_of(field).has_example()) return rule_of(field).example();
  return field->is_repeated() ? "[" + example_element(field) + "]" : example_element(field);
}

std::string example(const Descriptor* type) {
  std::vector<std::string> members;
  for (int i = 0; i < type->field_count(); ++i)
    // An example that lacks a required field would be refused when a user copies it.
    if (rule_of(type->field(i)).required())
      members.push_back(type->field(i)->name() + ": " + example(type->field(i)));
  if (members.empty()) {
    const FieldDescriptor* first = oldest_field(type);
    members.push_back(first->name() + ": " + example(first));
  }
  return "{" + join(members) + "}";
}

std::string expectation(const FieldDescriptor* field) {
  const scene::Rule& rule = rule_of(field);
  switch (field->cpp_type()) {
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return "a mapping such as `" + example(field->message_type()) + "`";
    case FieldDescriptor::CPPTYPE_ENUM:
      return "one of " + join(enumerators(field->enum_type()));
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return quantity_name(rule.unit()) +
             (limits(rule).empty() ? " such as `" + example_element(field) + "`" : limits(rule));
    case FieldDescriptor::CPPTYPE_BOOL:
      return "true or false";
    case FieldDescriptor::CPPTYPE_STRING:
      return is_name_field(field) ? "a name of letters, digits, `_`, `-`, and `.` but not first, at most " +
                                        std::to_string(kLongestName) + " bytes"
                                  : "a text";
    default:
      return "a whole number" + limits(rule);
  }
}

std::string quantity_of(const FieldDescriptor* field) {
  return quantity_name(rule_of(field).unit());
}

std::string in_unit(double value, const FieldDescriptor* field) {
  const std::string& unit = rule_of(field).unit();
  return shortest(value) + (unit.empty() ? "" : " " + unit);
}

bool is_name_field(const FieldDescriptor* field) {
  return field->name() == "name" && field->cpp_type() == FieldDescriptor::CPPTYPE_STRING;
}

bool fit_for_a_name(std::string_view text) {
  const auto fits = [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '-' || c == '.' || c > 127;  // letters of other scripts
  };
  return !text.empty() && text.size() <= kLongestName && text.front() != '.' &&
         std::ranges::all_of(text, fits) && is_one_visible_word(text);
}

bool within(const scene::Rule& rule, double value) {
  return (!rule.has_above() || value > rule.above()) && (!rule.has_at_least() || value >= rule.at_least()) &&
         (!rule.has_below() || value < rule.below()) && (!rule.has_at_most() || value <= rule.at_most());
}

}  // namespace adit::protocol

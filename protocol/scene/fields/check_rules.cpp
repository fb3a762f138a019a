#include "protocol/scene/fields/check_rules.hpp"

#include <fmt/format.h>
#include <google/protobuf/unknown_field_set.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "protocol/errors.hpp"
#include "protocol/scene/fields/path.hpp"
#include "protocol/scene/fields/rules.hpp"
#include "protocol/text.hpp"

namespace adit::protocol {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

[[noreturn]] void refuse(const std::string& path, const std::string& found, const std::string& expected) {
  throw UserError(path, "is " + found + ", expected " + expected);
}

// The elements of a list, 1 for a single field.
int count(const Message& message, const FieldDescriptor* field) {
  return field->is_repeated() ? message.GetReflection()->FieldSize(message, field) : 1;
}

// A text or a list that holds nothing counts as not given.
bool is_given(const Message& message, const FieldDescriptor* field) {
  const auto& get = *message.GetReflection();
  if (field->is_repeated()) return get.FieldSize(message, field) > 0;
  if (!get.HasField(message, field)) return false;
  return field->cpp_type() != FieldDescriptor::CPPTYPE_STRING || !get.GetString(message, field).empty();
}

// The number that a field or its element `i` holds; nothing where it holds none.
std::optional<double> number(const Message& message, const FieldDescriptor* field, int i) {
  const auto& get = *message.GetReflection();
  const bool list = field->is_repeated();
  switch (field->cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return list ? get.GetRepeatedDouble(message, field, i) : get.GetDouble(message, field);
    case FieldDescriptor::CPPTYPE_UINT32:
      return list ? get.GetRepeatedUInt32(message, field, i) : get.GetUInt32(message, field);
    case FieldDescriptor::CPPTYPE_UINT64:
      return static_cast<double>(list ? get.GetRepeatedUInt64(message, field, i)
                                      : get.GetUInt64(message, field));
    default:
      return std::nullopt;
  }
}

bool may_be_infinite(const FieldDescriptor* field) {
  // A default of infinity says that infinity has a meaning for the field: no limit.
  return field->cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE && std::isinf(field->default_value_double());
}

void check_number(double value, const FieldDescriptor* field, const std::string& path) {
  if (std::isnan(value)) refuse(path, "not a number", expectation(field));
  if (std::isinf(value) && !may_be_infinite(field)) refuse(path, "infinite", expectation(field));
  if (!within(rule_of(field), value)) refuse(path, in_unit(value, field), expectation(field));
  // Degrees whose unit was forgotten; an arc may end in its second turn.
  constexpr double kTwoTurns = 4 * std::numbers::pi;
  if (rule_of(field).unit() == "rad" && std::abs(value) > kTwoTurns)
    refuse(path, in_unit(value, field),
           fmt::format("an angle within two turns; a number without a unit is in radians, in degrees it is "
                       "`{:.6g} deg`",
                       value));
}

void check_value(const Message& message, const FieldDescriptor* field, int i, const std::string& path) {
  const auto& get = *message.GetReflection();
  if (field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE)
    check_rules(
        field->is_repeated() ? get.GetRepeatedMessage(message, field, i) : get.GetMessage(message, field),
        path);
  else if (const auto value = number(message, field, i))
    check_number(*value, field, path);
  else if (is_name_field(field) && !fit_for_a_name(get.GetString(message, field)))
    refuse(path, quote(get.GetString(message, field)), expectation(field));
}

// The other number of the rules `above_field` and `at_least_field`, given or by its default.
std::optional<double> number_beside(const Message& message, const std::string& name) {
  const FieldDescriptor* other = message.GetDescriptor()->FindFieldByName(name);
  if (!message.GetReflection()->HasField(message, other) && !other->has_default_value()) return std::nullopt;
  return number(message, other, 0);
}

void check_number_beside(const Message& message, const FieldDescriptor* field, const std::string& path) {
  const scene::Rule& rule = rule_of(field);
  const std::string& name = rule.has_above_field() ? rule.above_field() : rule.at_least_field();
  if (name.empty()) return;
  const auto other = number_beside(message, name), value = number_beside(message, field->name());
  if (!other || !value || *value > *other || (*value == *other && rule.has_at_least_field())) return;
  refuse(path, in_unit(*value, field),
         quantity_of(field) + (rule.has_above_field() ? " above " : " of at least ") + "`" + name +
             "` = " + in_unit(*other, field));
}

[[noreturn]] void refuse_length(const std::string& path, int elements, const std::string& expected) {
  throw UserError(path, "has " + std::to_string(elements) + " elements, expected " + expected);
}

void check_list_beside(const Message& message, const FieldDescriptor* field, const std::string& path) {
  const std::string& name = rule_of(field).as_many_as();
  if (name.empty()) return;
  const int elements = count(message, field);
  const int others = count(message, message.GetDescriptor()->FindFieldByName(name));
  if (elements != others)
    refuse_length(path, elements, std::to_string(others) + ", as many as `" + name + "`");
}

void check_length(const Message& message, const FieldDescriptor* field, const std::string& path) {
  const scene::Rule& rule = rule_of(field);
  const int elements = count(message, field);
  const int exact = static_cast<int>(rule.elements()), least = static_cast<int>(rule.min_elements());
  if (rule.has_elements() && elements != exact) refuse_length(path, elements, std::to_string(exact));
  if (elements < least) refuse_length(path, elements, "at least " + std::to_string(least));
}

void check_order(const Message& message, const FieldDescriptor* field, const std::string& path) {
  for (int i = 1; i < count(message, field); ++i) {
    const double before = *number(message, field, i - 1), value = *number(message, field, i);
    if (value <= before)
      refuse(element_path(path, i), in_unit(value, field),
             "more than the " + in_unit(before, field) + " before it");
  }
}

void check_field(const Message& message, const FieldDescriptor* field, const std::string& path) {
  if (!field->is_repeated()) return check_value(message, field, 0, path);
  for (int i = 0; i < count(message, field); ++i) check_value(message, field, i, element_path(path, i));
  check_length(message, field, path);
  if (rule_of(field).increasing()) check_order(message, field, path);
}

// A sender of a newer release may know keys, and values of keys, that are not known here.
void refuse_unknown(const Message& message, const std::string& path) {
  const auto& unknown = message.GetReflection()->GetUnknownFields(message);
  if (unknown.empty()) return;
  throw UserError(path,
                  fmt::format("holds a key or a value that this release does not know (field {} of {}): "
                              "install the same release at both ends, or leave it out",
                              unknown.field(0).number(), message.GetDescriptor()->name()));
}

}  // namespace

void check_rules(const Message& message, const std::string& path) {
  refuse_unknown(message, path);
  const auto* type = message.GetDescriptor();
  for (int i = 0; i < type->field_count(); ++i)
    if (is_given(message, type->field(i)))
      check_field(message, type->field(i), member_path(path, type->field(i)->name()));
  for (int i = 0; i < type->field_count(); ++i) {
    const FieldDescriptor* field = type->field(i);
    const std::string here = member_path(path, field->name());
    if (rule_of(field).required() && !is_given(message, field))
      throw UserError(here, "is missing; write for example `" + field->name() + ": " + example(field) + "`");
    check_number_beside(message, field, here);
    check_list_beside(message, field, here);
  }
}

}  // namespace adit::protocol

#include "protocol/scene/yaml/message_reader.hpp"

#include <google/protobuf/descriptor.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "protocol/errors.hpp"
#include "protocol/nearest_name.hpp"
#include "protocol/scene/fields/path.hpp"
#include "protocol/scene/fields/quantity.hpp"
#include "protocol/scene/fields/rules.hpp"
#include "protocol/text.hpp"

namespace adit::protocol {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;
using Kind = YamlValue::Kind;

std::string found(const YamlValue& value) {
  switch (value.kind) {
    case Kind::kNull:
      return "is empty";
    case Kind::kScalar:
      return "is " + quote(value.scalar);
    case Kind::kList:
      return "is a list";
    case Kind::kMapping:
      return "is a mapping";
  }
  return {};
}

// One value of one field with its place, so that every step of reading it can refuse it.
struct Reading {
  const YamlValue& value;
  const std::string& path;
  const FieldDescriptor* field;

  [[noreturn]] void refuse(const std::string& what) const { refuse_at(value.place, path, what); }

  // A number beyond its limits is refused here already, because here it can be quoted as it was written.
  void require_within(double number) const {
    if (within(rule_of(field), number)) return;
    // A number without a unit is in the unit of the field, which the message then names.
    const char* end = value.scalar.data() + value.scalar.size();
    double bare = 0;
    const bool is_bare = std::from_chars(value.scalar.data(), end, bare).ptr == end;
    refuse("is " + (is_bare ? in_unit(number, field) : shorten(value.scalar)) + ", expected " +
           expectation(field));
  }
};

double read_double(const Reading& r) {
  double number = 0;
  try {
    number = parse_quantity(r.value.scalar, rule_of(r.field).unit());
  } catch (const UserError& error) {
    r.refuse(error.what());
  }
  r.require_within(number);
  return number;
}

template <class Whole>
Whole read_whole(const Reading& r) {
  Whole number = 0;
  const std::string& text = r.value.scalar;
  const char* end = text.data() + text.size();
  const auto [after, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || after != end)
    r.refuse(found(r.value) + ", expected " + expectation(r.field) + ", such as `" + example(r.field) + "`");
  r.require_within(static_cast<double>(number));
  return number;
}

bool read_bool(const Reading& r) {
  if (r.value.scalar != "true" && r.value.scalar != "false")
    r.refuse(found(r.value) + ", expected " + expectation(r.field));
  return r.value.scalar == "true";
}

int read_enum(const Reading& r) {
  const auto names = enumerators(r.field->enum_type());
  const auto name = std::ranges::find(names, r.value.scalar);
  if (name == names.end())
    r.refuse(found(r.value) + ", expected " + expectation(r.field) + did_you_mean(r.value.scalar, names));
  return r.field->enum_type()->value(static_cast<int>(name - names.begin()))->number();
}

// Sets the field, or adds an element to a repeated one.
void read_scalar(const Reading& r, Message& message) {
  const Reflection& set = *message.GetReflection();
  const bool repeated = r.field->is_repeated();
  switch (r.field->cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return repeated ? set.AddDouble(&message, r.field, read_double(r))
                      : set.SetDouble(&message, r.field, read_double(r));
    case FieldDescriptor::CPPTYPE_UINT32:
      return repeated ? set.AddUInt32(&message, r.field, read_whole<std::uint32_t>(r))
                      : set.SetUInt32(&message, r.field, read_whole<std::uint32_t>(r));
    case FieldDescriptor::CPPTYPE_UINT64:
      return repeated ? set.AddUInt64(&message, r.field, read_whole<std::uint64_t>(r))
                      : set.SetUInt64(&message, r.field, read_whole<std::uint64_t>(r));
    case FieldDescriptor::CPPTYPE_BOOL:
      return repeated ? set.AddBool(&message, r.field, read_bool(r))
                      : set.SetBool(&message, r.field, read_bool(r));
    case FieldDescriptor::CPPTYPE_ENUM:
      return repeated ? set.AddEnumValue(&message, r.field, read_enum(r))
                      : set.SetEnumValue(&message, r.field, read_enum(r));
    case FieldDescriptor::CPPTYPE_STRING:
      return repeated ? set.AddString(&message, r.field, r.value.scalar)
                      : set.SetString(&message, r.field, r.value.scalar);
    default:
      throw std::logic_error("scene.proto: the reader knows no type " +
                             std::string(r.field->cpp_type_name()) + " (" + r.field->full_name() + ")");
  }
}

void read_value(const YamlValue& value, const std::string& path, const FieldDescriptor* field,
                Message& message) {
  if (field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
    const Reflection& set = *message.GetReflection();
    read_message(
        value, path,
        *(field->is_repeated() ? set.AddMessage(&message, field) : set.MutableMessage(&message, field)));
    return;
  }
  const Reading reading{value, path, field};
  if (value.kind != Kind::kScalar) reading.refuse(found(value) + ", expected " + expectation(field));
  read_scalar(reading, message);
}

void read_field(const YamlValue& value, const std::string& path, const FieldDescriptor* field,
                Message& message) {
  if (!field->is_repeated()) return read_value(value, path, field, message);
  if (value.kind != Kind::kList)
    refuse_at(value.place, path, found(value) + ", expected a list such as `" + example(field) + "`");
  for (std::size_t i = 0; i < value.children.size(); ++i)
    read_value(value.children[i], element_path(path, i), field, message);
}

const FieldDescriptor* find_field(const YamlValue& member, const std::string& path, const Message& message) {
  const auto* type = message.GetDescriptor();
  const FieldDescriptor* field = type->FindFieldByName(member.key);
  if (!field || is_internal(field)) {
    const auto names = field_names(type);
    const std::string guess = did_you_mean(member.key, names);
    refuse_at(member.place, member_path(path, shorten(member.key)),
              "unknown" + (guess.empty() ? ";" : guess) + " known here: " + join(names));
  }
  // Protobuf keeps the last member of a oneof and forgets the others, so a second one is refused here.
  const auto* oneof = field->real_containing_oneof();
  if (oneof && message.GetReflection()->HasOneof(message, oneof)) {
    std::vector<std::string> names;
    for (int i = 0; i < oneof->field_count(); ++i) names.push_back(oneof->field(i)->name());
    const auto* other = message.GetReflection()->GetOneofFieldDescriptor(message, oneof);
    refuse_at(member.place, member_path(path, member.key),
              "is given beside " + quote(other->name()) + "; keep one of " + join(names));
  }
  return field;
}

}  // namespace

void read_message(const YamlValue& value, const std::string& path, Message& message) {
  if (value.kind != Kind::kMapping)
    refuse_at(value.place, path,
              (path.empty() ? "the scene " : "") + found(value) + ", expected a mapping such as `" +
                  example(message.GetDescriptor()) + "`");
  for (const YamlValue& member : value.children) {
    const FieldDescriptor* field = find_field(member, path, message);
    read_field(member, member_path(path, member.key), field, message);
  }
}

}  // namespace adit::protocol

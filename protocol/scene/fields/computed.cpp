#include "protocol/scene/fields/computed.hpp"

#include <fmt/format.h>

#include <set>
#include <vector>

#include "protocol/errors.hpp"
#include "protocol/scene/fields/path.hpp"
#include "protocol/text.hpp"

namespace adit::protocol {
namespace {

using google::protobuf::EnumValueDescriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

class Requirement {
 public:
  Requirement(const Computed& computed, const std::string& program)
      : computed_(computed.begin(), computed.end()), program_(program) {}

  // `path` is the field's place in the scene, `key` the same without numbers of list elements.
  void require(const Message& message, const FieldDescriptor* field, const std::string& path,
               const std::string& key) const {
    if (computed_.count(key)) return;
    switch (field->cpp_type()) {
      case FieldDescriptor::CPPTYPE_MESSAGE:
        return require_inside(message, field, path, key);
      case FieldDescriptor::CPPTYPE_ENUM:
        return require_values(message, field, path, key);
      default:
        if (!has_default(message, field)) refuse(path, "is not computed");
    }
  }

  void require_fields(const Message& message, const std::string& path, const std::string& key) const {
    std::vector<const FieldDescriptor*> fields;
    message.GetReflection()->ListFields(message, &fields);
    for (const FieldDescriptor* field : fields)
      require(message, field, member_path(path, field->name()), member_path(key, field->name()));
  }

 private:
  [[noreturn]] void refuse(const std::string& path, const std::string& what) const {
    throw UserError(path, fmt::format("{} by {}; leave it out, or use another participant", what, program_));
  }

  void require_inside(const Message& message, const FieldDescriptor* field, const std::string& path,
                      const std::string& key) const {
    const auto some = computed_.lower_bound(key + ".");
    if (some == computed_.end() || some->compare(0, key.size() + 1, key + ".") != 0)
      refuse(path, "is not computed");
    const auto& get = *message.GetReflection();
    if (!field->is_repeated()) return require_fields(get.GetMessage(message, field), path, key);
    for (int i = 0; i < get.FieldSize(message, field); ++i)
      require_fields(get.GetRepeatedMessage(message, field, i),
                     element_path(path, static_cast<std::size_t>(i)), key);
  }

  void require_values(const Message& message, const FieldDescriptor* field, const std::string& path,
                      const std::string& key) const {
    const auto& get = *message.GetReflection();
    const auto require_value = [&](const EnumValueDescriptor* value) {
      const std::string name = lower_case(value->name());
      if (value != field->default_value_enum() && !computed_.count(member_path(key, name)))
        refuse(path, "is `" + name + "`, which is not computed");
    };
    if (!field->is_repeated()) return require_value(get.GetEnum(message, field));
    for (int i = 0; i < get.FieldSize(message, field); ++i)
      require_value(get.GetRepeatedEnum(message, field, i));
  }

  // A key that says what holds without it asks for nothing.
  static bool has_default(const Message& message, const FieldDescriptor* field) {
    if (field->is_repeated()) return false;
    const auto& get = *message.GetReflection();
    switch (field->cpp_type()) {
      case FieldDescriptor::CPPTYPE_DOUBLE:
        return get.GetDouble(message, field) == field->default_value_double();
      case FieldDescriptor::CPPTYPE_UINT32:
        return get.GetUInt32(message, field) == field->default_value_uint32();
      case FieldDescriptor::CPPTYPE_UINT64:
        return get.GetUInt64(message, field) == field->default_value_uint64();
      case FieldDescriptor::CPPTYPE_BOOL:
        return get.GetBool(message, field) == field->default_value_bool();
      case FieldDescriptor::CPPTYPE_STRING:
        return get.GetString(message, field) == field->default_value_string();
      default:
        return false;
    }
  }

  std::set<std::string> computed_;
  const std::string& program_;
};

}  // namespace

void require_computed(const scene::Scene& part, const std::string& model, const std::string& path,
                      const Computed& computed, const std::string& program) {
  if (computed.empty())
    throw UserError(
        "", program +
                " does not say in its hello what it computes (`computes`), so that it might leave out a "
                "part of the scene; let it list the keys (docs/protocol.md)");
  const Requirement requirement(computed, program);
  std::vector<const FieldDescriptor*> fields;
  part.GetReflection()->ListFields(part, &fields);
  for (const FieldDescriptor* field : fields)
    requirement.require(part, field, field->name() == model ? path : field->name(), field->name());
}

}  // namespace adit::protocol

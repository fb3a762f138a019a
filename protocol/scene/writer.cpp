#include "protocol/scene/writer.hpp"

#include <yaml-cpp/emitter.h>

#include <stdexcept>
#include <vector>

#include "protocol/scene/fields/rules.hpp"
#include "protocol/text.hpp"

namespace adit::protocol {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

void emit(YAML::Emitter& out, const Message& message);

// Writes one value of a field: the field's own value if `index` is negative, otherwise that element of its
// list.
void emit_value(YAML::Emitter& out, const Message& message, const FieldDescriptor* field, int index) {
  const auto* reflection = message.GetReflection();
  const bool list = index >= 0;
  switch (field->cpp_type()) {
    case FieldDescriptor::CPPTYPE_MESSAGE:
      emit(out, list ? reflection->GetRepeatedMessage(message, field, index)
                     : reflection->GetMessage(message, field));
      break;
    case FieldDescriptor::CPPTYPE_ENUM:
      out << lower_case(
          (list ? reflection->GetRepeatedEnum(message, field, index) : reflection->GetEnum(message, field))
              ->name());
      break;
    case FieldDescriptor::CPPTYPE_DOUBLE:
      out << shortest(list ? reflection->GetRepeatedDouble(message, field, index)
                           : reflection->GetDouble(message, field));
      break;
    case FieldDescriptor::CPPTYPE_UINT32:
      out << (list ? reflection->GetRepeatedUInt32(message, field, index)
                   : reflection->GetUInt32(message, field));
      break;
    case FieldDescriptor::CPPTYPE_UINT64:
      out << (list ? reflection->GetRepeatedUInt64(message, field, index)
                   : reflection->GetUInt64(message, field));
      break;
    case FieldDescriptor::CPPTYPE_BOOL:
      out << (list ? reflection->GetRepeatedBool(message, field, index)
                   : reflection->GetBool(message, field));
      break;
    case FieldDescriptor::CPPTYPE_STRING:
      // Quoted, because a bare `true` or `1.0` is a text to the scene but another type to other readers of
      // YAML.
      out << YAML::DoubleQuoted
          << (list ? reflection->GetRepeatedString(message, field, index)
                   : reflection->GetString(message, field));
      break;
    default:
      throw std::logic_error("scene.proto uses a type that the scene writer does not know: " +
                             field->full_name());
  }
}

void emit(YAML::Emitter& out, const Message& message) {
  std::vector<const FieldDescriptor*> fields;
  message.GetReflection()->ListFields(message, &fields);
  out << YAML::BeginMap;
  for (const FieldDescriptor* field : fields) {
    // Bases are merged already, and contents of files are read again from the paths beside them.
    if (field->full_name() == "adit.scene.Scene.extends" || is_internal(field)) continue;
    out << YAML::Key << field->name() << YAML::Value;
    if (!field->is_repeated()) {
      emit_value(out, message, field, -1);
      continue;
    }
    out << YAML::BeginSeq;
    for (int i = 0; i < message.GetReflection()->FieldSize(message, field); ++i)
      emit_value(out, message, field, i);
    out << YAML::EndSeq;
  }
  out << YAML::EndMap;
}

}  // namespace

std::string to_yaml(const Message& scene) {
  YAML::Emitter out;
  emit(out, scene);
  return std::string(out.c_str()) + "\n";
}

}  // namespace adit::protocol

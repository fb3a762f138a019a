#include "protocol/scene/attached_files.hpp"

#include <filesystem>
#include <utility>
#include <vector>

#include "protocol/scene/fields/path.hpp"
#include "protocol/scene/fields/rules.hpp"
#include "protocol/scene/file_content.hpp"
#include "protocol/text.hpp"
#include "protocol/wire/bounds.hpp"

namespace adit::protocol {
namespace {

namespace fs = std::filesystem;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

std::string content(const fs::path& path, const std::string& field, std::uintmax_t& room) {
  const auto refuse = [&](const std::string& reason) {
    throw UserError(field, quote(path.string()) + ": " + reason);
  };
  std::error_code error;
  if (!fs::exists(path, error))
    refuse(
        "there is no such file; check the path, which is relative to the scene file that gives it (with "
        "--set: "
        "to the current folder)");
  if (!fs::is_regular_file(path, error)) refuse("this is not a file");
  // The size is known before a byte is read, so a wrong path cannot fill the memory.
  const std::uintmax_t size = fs::file_size(path, error);
  if (size > room)
    refuse("with this file those of the scene are larger than " + std::to_string(kMaxAttachedBytes >> 20) +
           " MiB; use a coarser mesh or a shorter record");
  room -= size;
  auto bytes = file_content(path);
  if (!bytes) refuse("the file cannot be read; check its permissions");
  return std::move(*bytes);
}

const FieldDescriptor* name_of(const Message& message, const FieldDescriptor* content) {
  return message.GetDescriptor()->FindFieldByName(rule_of(content).content_of());
}

void attach_one(const SceneFile& scene, Message& message, const FieldDescriptor* into,
                const std::string& path, std::uintmax_t& room) {
  const auto& reflection = *message.GetReflection();
  const FieldDescriptor* name = name_of(message, into);
  if (!reflection.HasField(message, name)) return;
  const std::string field = member_path(path, name->name());
  const fs::path file = fs::path(scene.folder(field)) / reflection.GetString(message, name);
  reflection.SetString(&message, into, content(file, field, room));
  reflection.SetString(&message, name, valid_utf8(fs::absolute(file).lexically_normal().string()));
}

// Calls visit(message, field, path) for every field within the message that holds the content of a file.
template <class Visit>
void for_each_content(Message& message, const std::string& path, const Visit& visit) {
  const auto& reflection = *message.GetReflection();
  const auto* type = message.GetDescriptor();
  for (int i = 0; i < type->field_count(); ++i) {
    const FieldDescriptor* field = type->field(i);
    const std::string at = member_path(path, field->name());
    if (is_internal(field)) {
      visit(message, field, path);
    } else if (field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE && field->is_repeated()) {
      for (int k = 0; k < reflection.FieldSize(message, field); ++k)
        for_each_content(*reflection.MutableRepeatedMessage(&message, field, k),
                         element_path(at, static_cast<std::size_t>(k)), visit);
      // MutableMessage() would add a message that is not given, so that is asked first.
    } else if (field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE && reflection.HasField(message, field)) {
      for_each_content(*reflection.MutableMessage(&message, field), at, visit);
    }
  }
}

}  // namespace

void attach_files(SceneFile& file) {
  std::uintmax_t room = kMaxAttachedBytes;
  for_each_content(file.scene, "",
                   [&](Message& message, const FieldDescriptor* into, const std::string& path) {
                     attach_one(file, message, into, path, room);
                   });
}

void for_each_attached_file(
    const scene::Scene& scene,
    const std::function<void(const std::string& path, const std::string& content)>& visit) {
  scene::Scene copy = scene;  // reflection walks messages that may change
  for_each_content(copy, "", [&](Message& message, const FieldDescriptor* field, const std::string&) {
    const auto& reflection = *message.GetReflection();
    if (reflection.HasField(message, field))
      visit(reflection.GetString(message, name_of(message, field)), reflection.GetString(message, field));
  });
}

void forget_file_names(scene::Scene& scene) {
  for_each_content(scene, "", [](Message& message, const FieldDescriptor* field, const std::string&) {
    message.GetReflection()->ClearField(&message, name_of(message, field));
  });
}

}  // namespace adit::protocol

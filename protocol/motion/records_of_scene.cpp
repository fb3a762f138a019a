#include "protocol/motion/records_of_scene.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include "protocol/motion/errors_at.hpp"
#include "protocol/motion/records.hpp"
#include "protocol/scene_path.hpp"

namespace adit::motion {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

void read_record(const protocol::SceneFile& scene, const std::string& path, scene::MotionFile& file) {
  if (!file.acceleration().empty()) return;
  const std::string field = path + ".path";
  const Motion motion =
      errors_at(field, [&] { return read_motion(std::filesystem::path(scene.folder(field)) / file.path()); });
  file.set_step(motion.dt);
  file.mutable_acceleration()->Assign(motion.acceleration.begin(), motion.acceleration.end());
}

void read_below(const protocol::SceneFile& scene, const std::string& path, Message& message) {
  if (message.GetDescriptor() == scene::MotionFile::descriptor())
    return read_record(scene, path, static_cast<scene::MotionFile&>(message));
  const auto* reflection = message.GetReflection();
  std::vector<const FieldDescriptor*> fields;
  reflection->ListFields(message, &fields);
  for (const FieldDescriptor* field : fields) {
    if (field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) continue;
    const std::string below = protocol::member_path(path, field->name());
    if (!field->is_repeated()) {
      read_below(scene, below, *reflection->MutableMessage(&message, field));
      continue;
    }
    for (int i = 0; i < reflection->FieldSize(message, field); ++i)
      read_below(scene, protocol::element_path(below, static_cast<std::size_t>(i)),
                 *reflection->MutableRepeatedMessage(&message, field, i));
  }
}

}  // namespace

void read_records(protocol::SceneFile& file) {
  read_below(file, "", file.scene);
}

}  // namespace adit::motion

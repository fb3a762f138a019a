// A scene. What was read is written and read back as it was.
#include <google/protobuf/util/message_differencer.h>

#include <stdexcept>

#include "protocol/scene/fields/check_rules.hpp"
#include "protocol/scene/writer.hpp"
#include "protocol/scene/yaml/message_reader.hpp"
#include "tests/fuzz/support/target.hpp"

namespace adit::fuzz {
namespace {

scene::Scene read(const std::string& text) {
  scene::Scene scene;
  protocol::read_message(protocol::parse_yaml(text, "x.yaml"), "", scene);
  return scene;
}

const Target kScene("scene", [](std::string_view input) {
  const std::string text(input);
  read_or_refuse([&] {
    scene::Scene scene = read(text);
    scene.clear_extends();  // it was merged
    if (!google::protobuf::util::MessageDifferencer::Equals(scene, read(protocol::to_yaml(scene))))
      throw std::logic_error("the scene is another one after it was written and read");
    protocol::check_rules(scene);
  });
});

}  // namespace
}  // namespace adit::fuzz

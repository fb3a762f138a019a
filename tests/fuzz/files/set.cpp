// `--set` on the command line: the first line is `path=value`, the rest is the scene.
#include <algorithm>

#include "protocol/messages/scene.pb.h"
#include "protocol/scene/yaml/merge.hpp"
#include "protocol/scene/yaml/message_reader.hpp"
#include "tests/fuzz/support/target.hpp"

namespace adit::fuzz {
namespace {

const Target kSet("set", [](std::string_view input) {
  const auto end = std::min(input.find('\n'), input.size());
  const std::vector<std::string> sets{std::string(input.substr(0, end))};
  read_or_refuse([&] {
    auto tree = protocol::parse_yaml(std::string(input.substr(end)), "x.yaml");
    for (const auto& one : protocol::parse_overrides(sets))
      protocol::apply(one, tree, scene::Scene::descriptor());
    scene::Scene scene;
    protocol::read_message(tree, "", scene);
  });
});

}  // namespace
}  // namespace adit::fuzz

#include "protocol/scene/reader.hpp"

#include <filesystem>
#include <fstream>
#include <set>
#include <utility>
#include <vector>

#include "protocol/scene/fields/check_rules.hpp"
#include "protocol/scene/fields/path.hpp"
#include "protocol/scene/file_content.hpp"
#include "protocol/scene/fill_in_concrete.hpp"
#include "protocol/scene/yaml/message_reader.hpp"
#include "protocol/text.hpp"

namespace adit::protocol {
namespace {

namespace fs = std::filesystem;

// The reason why the file cannot be read, with the remedy; empty if it can.
std::string obstacle(const fs::path& path) {
  std::error_code error;
  const auto status = fs::status(path, error);
  if (!fs::exists(status)) return "there is no such file; check the path";
  if (!fs::is_regular_file(status)) return "this is not a file; name a scene file";
  if (fs::file_size(path, error) > kLargestSceneBytes)
    return "the file is larger than " + std::to_string(kLargestSceneBytes >> 20) +
           " MiB; thin out its tables";
  if (!std::ifstream(path)) return "the file cannot be opened; check its permissions";
  return {};
}

// The file that `extends` names, relative to the file `from` in which it stands.
fs::path extended_path(const fs::path& from, const YamlValue& extends) {
  if (extends.kind != YamlValue::Kind::kScalar || extends.scalar.empty())
    refuse_at(extends.place, "extends", "expected the path of a scene file, such as `other.yaml`");
  fs::path path = (from.parent_path() / extends.scalar).lexically_normal();
  const std::string reason = obstacle(path);
  if (!reason.empty()) refuse_at(extends.place, "extends", quote(path.string()) + ": " + reason);
  return path;
}

// Scenes written before `extends` had its name called it `base`.
void rename_base(YamlValue& layer, std::vector<std::string>& warnings) {
  YamlValue* base = layer.find("base");
  if (!base) return;
  if (layer.find("extends"))
    refuse_at(base->place, "base", "is given beside `extends`, its new name; keep that");
  warnings.push_back(base->place.text() +
                     ": base: is now called `extends`; write `extends: " + shorten(base->scalar) + "`");
  base->key = "extends";
}

// The file and the chain of those that it extends, the file first.
std::vector<YamlValue> load_layers(fs::path path, std::vector<std::string>& warnings) {
  std::vector<YamlValue> layers{load_yaml(path)};
  // Canonical paths, because a file can be reached by several spellings and links.
  std::set<fs::path> seen{fs::canonical(path)};
  while (true) {
    rename_base(layers.back(), warnings);
    const YamlValue* extends = layers.back().find("extends");
    if (!extends) return layers;
    path = extended_path(path, *extends);
    if (!seen.insert(fs::canonical(path)).second)
      refuse_at(extends->place, "extends",
                quote(path.string()) + " extends this file; no scene extends itself");
    layers.push_back(load_yaml(path));
  }
}

YamlValue merge_layers(std::vector<YamlValue> layers) {
  YamlValue tree = std::move(layers.back());
  for (layers.pop_back(); !layers.empty(); layers.pop_back()) {
    std::erase_if(tree.children, [](const YamlValue& member) { return member.key == "name"; });
    merge(tree, std::move(layers.back()), scene::Scene::descriptor());
  }
  return tree;
}

}  // namespace

YamlValue load_yaml(const std::string& path) {
  const std::string reason = obstacle(path);
  if (!reason.empty()) throw UserError("", path + ": " + reason);
  const auto content = file_content(path);
  if (!content) throw UserError("", path + ": the file cannot be read; name a scene file");
  return parse_yaml(*content, path);
}

const YamlValue& nearest(const YamlValue& tree, std::string_view field) {
  const YamlValue* value = &tree;
  const auto steps = parse_path(field);
  for (const PathStep& step : steps ? *steps : std::vector<PathStep>{}) {
    const YamlValue* next = value->find(step.name);
    if (!next) break;
    value = next;
    if (!step.index) continue;
    if (*step.index >= value->children.size()) break;
    value = &value->children[*step.index];
  }
  return *value;
}

std::string SceneFile::locate(std::string_view field) const {
  return nearest(tree, field).place.text();
}

std::string SceneFile::folder(std::string_view field) const {
  const Place& place = nearest(tree, field).place;
  return place.line > 0 ? fs::path(*place.source).parent_path().string() : "";
}

SceneFile read_scene(const std::string& path, std::span<const Override> sets) {
  SceneFile file;
  file.tree = merge_layers(load_layers(path, file.warnings));
  for (const Override& set : sets) apply(set, file.tree, scene::Scene::descriptor());
  read_message(file.tree, "", file.scene);
  if (file.scene.name().empty()) file.scene.set_name(fs::path(path).stem().string());
  try {
    fill_in_concrete(file.scene);
    check_rules(file.scene);
  } catch (const UserError& error) {
    throw UserError("", describe(file, error));
  }
  return file;
}

std::string describe(const SceneFile& file, const UserError& error) {
  if (error.path().empty()) return error.what();
  return file.locate(error.path()) + ": " + error.path() + ": " + error.what();
}

}  // namespace adit::protocol

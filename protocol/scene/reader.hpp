// Reads a scene file: YAML whose keys, types, units, limits and defaults are those of scene.proto.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/errors.hpp"
#include "protocol/messages/scene.pb.h"
#include "protocol/scene/yaml/merge.hpp"
#include "protocol/scene/yaml/yaml_tree.hpp"

namespace adit::protocol {

struct SceneFile {
  scene::Scene scene;  // fields that are not given are unset, and their getters return the defaults
  YamlValue tree;      // the merged scene as it was written
  std::vector<std::string> warnings;  // what the user should change: one sentence each, with its place

  // "file:line:column" (or "--set path=value") of the field, or of the innermost given field that contains
  // it.
  std::string locate(std::string_view field) const;

  // Folder of the file in which the field is given; paths in the field are relative to it. Empty for `--set`.
  std::string folder(std::string_view field) const;
};

// What a file of YAML holds, each value with its place. Throws UserError without a path if it cannot be read.
YamlValue load_yaml(const std::string& path);

// The value that stands at the path of a field, or the innermost given one that contains it.
const YamlValue& nearest(const YamlValue& tree, std::string_view field);

// Larger files are refused: a list of short numbers needs some 120 bytes of memory for each byte of its file.
constexpr std::uintmax_t kLargestSceneBytes = 4 << 20;

// Reads the file at `path` over the files that it extends, then applies `sets` in their order and checks the
// rules of the scene. The `name` of an extended file does not pass to the file that extends it, so that
// variants of a case never share a results' folder. The former word for `extends`, `base`, is read with a
// warning.
//
// Throws UserError with an empty path() whose what() is one complete line:
//   cases/x.yaml:12:5: particles.packing.radius: is -0.1 m, expected a length above 0 m
SceneFile read_scene(const std::string& path, std::span<const Override> sets = {});

// The same line for an error that was found after reading and names its field by path(). The message of an
// error without a path, such as those of read_scene, is complete already.
std::string describe(const SceneFile& file, const UserError& error);

}  // namespace adit::protocol

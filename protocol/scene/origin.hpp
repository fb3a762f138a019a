// Where the results of a run come from, so that they can be computed again.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace adit::protocol {

struct SceneCommandLine;  // command_line.hpp
struct SceneFile;         // reader.hpp

struct Origin {
  std::string command;   // as it was typed, quoted for a shell
  std::string folder;    // in which it was typed
  std::string started;   // in UTC, as in 2026-01-31T23:59:59Z
  std::string revision;  // revision.hpp
  // Path and hash of the scene file and of the files that it names; their 64-bit FNV-1a hashes as
  // scene_hash().
  std::vector<std::pair<std::string, std::string>> inputs;
};

// The origin of a run that begins now.
Origin origin_of(const SceneCommandLine& line, const SceneFile& file, std::string_view revision);

}  // namespace adit::protocol

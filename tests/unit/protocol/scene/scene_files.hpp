// Scene files for tests, and the reader's result or error.
#pragma once

#include <string>
#include <vector>

#include "protocol/scene/reader.hpp"
#include "tests/support/scratch_folder.hpp"

namespace adit::protocol::testing {

using test::ScratchFolder;

// What read_scene says of the file, without the folder; empty where it accepts it.
inline std::string complaint(const ScratchFolder& folder, const std::string& name,
                             const std::vector<std::string>& sets = {}) {
  try {
    read_scene(folder.path(name), parse_overrides(sets));
    return {};
  } catch (const UserError& error) {
    std::string text = error.what();
    const std::string prefix = folder.path();
    for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix))
      text.erase(at, prefix.size());
    return text;
  }
}

inline std::string complaint_about(const std::string& text, const std::vector<std::string>& sets = {}) {
  const ScratchFolder folder;
  folder.write("x.yaml", text);
  return complaint(folder, "x.yaml", sets);
}

}  // namespace adit::protocol::testing

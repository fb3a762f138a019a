// A folder of scene files that lives as long as a test.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "protocol/scene_reader.hpp"

namespace adit::protocol::testing {

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "adit_scene_XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }

  // Writes the file and returns its path.
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path(name);
  }
  std::string path(const std::string& name = {}) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

// What read_scene says of the file, without the folder; empty where it accepts it.
inline std::string complaint(const TemporaryFolder& folder, const std::string& name,
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
  const TemporaryFolder folder;
  folder.write("x.yaml", text);
  return complaint(folder, "x.yaml", sets);
}

}  // namespace adit::protocol::testing

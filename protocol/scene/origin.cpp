#include "protocol/scene/origin.hpp"

#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "protocol/scene/attached_files.hpp"
#include "protocol/scene/command_line.hpp"
#include "protocol/scene/hash.hpp"

namespace adit::protocol {
namespace {

std::string now() {
  const std::time_t time = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&time, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

}  // namespace

Origin origin_of(const SceneCommandLine& line, const SceneFile& file, std::string_view revision) {
  std::error_code unknown;  // a folder that was removed has no name
  Origin origin{.command = line.command,
                .folder = std::filesystem::current_path(unknown).string(),
                .started = now(),
                .revision = std::string(revision),
                .inputs = {}};
  std::ifstream scene(line.scene, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(scene), {});
  origin.inputs.emplace_back(line.scene, hash_of_bytes(bytes));
  for_each_attached_file(file.scene, [&](const std::string& path, const std::string& content) {
    origin.inputs.emplace_back(path, hash_of_bytes(content));
  });
  return origin;
}

}  // namespace adit::protocol

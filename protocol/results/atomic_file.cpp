#include "protocol/results/atomic_file.hpp"

#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace adit::results {

void replace_file(const std::filesystem::path& path, std::string_view content) {
  // The part lies in the same folder, hence in the same file system, where a rename replaces the file at
  // once.
  std::filesystem::path part = path;
  part += ".part";
  // Streams do not say why they failed; errno does, if it was 0 before.
  errno = 0;
  std::ofstream file(part, std::ios::binary | std::ios::trunc);
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  file.close();
  if (!file) {
    throw std::runtime_error("cannot write " + part.string() + ": " + std::generic_category().message(errno));
  }
  std::filesystem::rename(part, path);
}

}  // namespace adit::results

#include "protocol/results/atomic_file.hpp"

#include "protocol/results/disk/growing_file.hpp"

namespace adit::results {

void replace_file(const std::filesystem::path& path, const std::function<void(GrowingFile&)>& write) {
  // The part lies in the same folder, hence in the same file system, where a rename replaces the file at
  // once.
  std::filesystem::path part = path;
  part += ".part";
  try {
    {
      GrowingFile file(part);
      write(file);
    }
    std::filesystem::rename(part, path);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw;
  }
}

void replace_file(const std::filesystem::path& path, std::string_view content) {
  replace_file(path, [content](GrowingFile& file) { file.append(content); });
}

}  // namespace adit::results

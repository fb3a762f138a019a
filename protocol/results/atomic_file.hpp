// Files that are complete or absent, even if the run is killed while writing.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace adit::results {

class GrowingFile;

// Replaces the file: writes `<path>.part` beside it and renames that. If it cannot be
// written, no part is left; errors are those of disk/write_error.hpp.
void replace_file(const std::filesystem::path& path, const std::function<void(GrowingFile&)>& write);
void replace_file(const std::filesystem::path& path, std::string_view content);

}  // namespace adit::results

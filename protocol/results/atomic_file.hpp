// Files that are complete or absent, even if the run is killed while writing.
#pragma once

#include <filesystem>
#include <string_view>

namespace adit::results {

// Replaces the file: writes `<path>.part` beside it and renames that. Throws std::runtime_error with the file
// and the system's reason if it cannot be written.
void replace_file(const std::filesystem::path& path, std::string_view content);

}  // namespace adit::results

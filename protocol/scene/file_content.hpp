// What lies in a file that the user names.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace adit::protocol {

// All bytes of a regular file; nothing where the system does not let them be read, be it on opening or later
// (/proc/self/mem).
std::optional<std::string> file_content(const std::filesystem::path& file);

}  // namespace adit::protocol

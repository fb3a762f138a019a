// Why a file could not be written.
#pragma once

#include <filesystem>

namespace adit::results {

// Throws protocol::DiskFull where the system's error says that there is no more room, protocol::UserError
// else; either names the file and the reason.
[[noreturn]] void throw_write_error(const std::filesystem::path& file, int error);

}  // namespace adit::results

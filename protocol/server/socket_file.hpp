// The file of a Unix socket at which a server listens.
#pragma once

#include <filesystem>

namespace adit::protocol {

// Removes the socket that a server left there when it was killed. Throws UserError if a server listens there,
// or the file is something else.
void make_room_for_socket(const std::filesystem::path& path);

// Nothing where the path is empty or the file has gone.
void remove_socket(const std::filesystem::path& path);

}  // namespace adit::protocol

// Files that only their owner may read.
#pragma once

#include <filesystem>
#include <string_view>

namespace adit::protocol {

// Throws UserError if the file, which holds `what` ("the secret"), is missing or other users may read or
// change it. Credentials that systemd hands to a service are private whatever their mode says.
void require_private(const std::filesystem::path& file, std::string_view what);

}  // namespace adit::protocol

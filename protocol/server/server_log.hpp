// The log of a server.
#pragma once

#include <string>

namespace adit::protocol {

// Begins it on standard error, with the least `level` that is told, as spdlog names it.
void begin_server_log(const std::string& program, const std::string& level, bool json);

}  // namespace adit::protocol

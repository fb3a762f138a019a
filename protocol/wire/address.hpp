// The address at which a server listens.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace adit::protocol {

struct Address {
  std::string host;
  std::uint16_t port = 0;  // 0: a server takes any free port
  std::string path = {};   // of a Unix socket of this machine, in the place of host and port
};

// Reads HOST:PORT, as in "127.0.0.1:4711", "tunnel.example.org:4711" or "[::1]:4711", or unix:PATH, as in
// "unix:/run/adit/fdm". Throws UserError on anything else, and for a PATH that is longer than the system
// takes.
Address parse_address(std::string_view text);

std::string to_string(const Address& address);

}  // namespace adit::protocol

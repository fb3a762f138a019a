// Where a server listens.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace adit::protocol {

struct Address {
  std::string host;
  std::uint16_t port = 0;  // 0: any free port, for a server
};

// "127.0.0.1:4711", "tunnel.example.org:4711", "[::1]:4711". Anything else is a UserError.
Address parse_address(std::string_view text);

std::string to_string(const Address& address);

}  // namespace adit::protocol

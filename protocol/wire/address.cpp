#include "protocol/wire/address.hpp"

#include <fmt/format.h>

#include <charconv>

#include "protocol/errors.hpp"

namespace adit::protocol {

Address parse_address(std::string_view text) {
  Address address;
  const auto colon = text.rfind(':');
  std::string_view host = text.substr(0, colon == text.npos ? 0 : colon);
  const std::string_view port = text.substr(colon == text.npos ? text.size() : colon + 1);
  const bool brackets = host.size() > 2 && host.front() == '[' && host.back() == ']';
  if (brackets) host = host.substr(1, host.size() - 2);
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), address.port);
  const bool bad_port = port.empty() || error != std::errc() || end != port.data() + port.size();
  // A bare IPv6 address has colons of its own, so its last part could be taken for a port: it needs brackets.
  if (host.empty() || bad_port || (!brackets && host.find(':') != host.npos)) {
    throw UserError("",
                    fmt::format("'{}' is not an address: write HOST:PORT with a port from 0 to 65535, as in "
                                "127.0.0.1:4711 or [::1]:4711",
                                text));
  }
  address.host = host;
  return address;
}

std::string to_string(const Address& address) {
  const bool v6 = address.host.find(':') != std::string::npos;
  return v6 ? fmt::format("[{}]:{}", address.host, address.port)
            : fmt::format("{}:{}", address.host, address.port);
}

}  // namespace adit::protocol

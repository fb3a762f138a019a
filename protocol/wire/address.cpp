#include "protocol/wire/address.hpp"

#include <fmt/format.h>
#include <sys/un.h>

#include <charconv>

#include "protocol/errors.hpp"
#include "protocol/text.hpp"

namespace adit::protocol {
namespace {

constexpr std::string_view kUnix = "unix:";
constexpr std::size_t kLongestPath = sizeof(sockaddr_un::sun_path) - 1;

Address parse_path(std::string_view path) {
  if (path.empty() || path.size() > kLongestPath)
    throw UserError("",
                    fmt::format("{} is not an address: write unix:PATH with a path of 1 to {} bytes, as "
                                "in unix:/run/adit/fdm; this one has {}",
                                quote(std::string(kUnix) + std::string(path)), kLongestPath, path.size()));
  return {.host = "", .port = 0, .path = std::string(path)};
}

}  // namespace

Address parse_address(std::string_view text) {
  if (text.starts_with(kUnix)) return parse_path(text.substr(kUnix.size()));
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
    throw UserError("", quote(text) +
                            " is not an address: write HOST:PORT with a port from 0 to 65535, as in "
                            "127.0.0.1:4711 or [::1]:4711, or unix:PATH");
  }
  address.host = host;
  return address;
}

std::string to_string(const Address& address) {
  if (!address.path.empty()) return fmt::format("{}{}", kUnix, address.path);
  const bool v6 = address.host.find(':') != std::string::npos;
  return v6 ? fmt::format("[{}]:{}", address.host, address.port)
            : fmt::format("{}:{}", address.host, address.port);
}

}  // namespace adit::protocol

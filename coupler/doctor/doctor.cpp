#include "coupler/doctor/doctor.hpp"

#include <spdlog/fmt/fmt.h>

#include <chrono>
#include <memory>
#include <vector>

#include "coupler/check/text.hpp"
#include "coupler/doctor/probe.hpp"
#include "protocol/errors.hpp"
#include "protocol/text.hpp"
#include "protocol/wire/address.hpp"
#include "protocol/wire/frame.hpp"
#include "protocol/wire/greeting.hpp"

namespace adit::coupler {
namespace {

using Clock = std::chrono::steady_clock;

// Does the work of a line; where it fails, the line says no.
template <class Work>
auto tell(const char* label, Work work) {
  try {
    return work();
  } catch (const std::exception&) {
    print_line(label, "no");
    throw;
  }
}

std::unique_ptr<protocol::Connection> reach(const protocol::Address& address) {
  return tell("reachable", [&] {
    const auto start = Clock::now();
    auto connection = protocol::connect(address, "a server");
    const std::chrono::duration<double, std::milli> took = Clock::now() - start;
    print_line("reachable", fmt::format("yes, within {:.2g} ms: {}", took.count(), connection->peer()));
    return connection;
  });
}

// A Unix socket lies on this machine and takes no TLS, as in a run.
void secure(protocol::Connection& connection, const Trust& trust, const protocol::Address& address) {
  tell("trusted", [&] {
    if (trust.tls && address.path.empty()) protocol::secure_server(connection, *trust.tls, address.host);
    const std::string certificate = connection.certificate();
    print_line("trusted", certificate.empty() ? "without TLS" : "TLS 1.3, certificate " + certificate);
  });
}

wire::Hello greet(protocol::Connection& connection, const Trust& trust) {
  const wire::Hello hello = tell("serves", [&] {
    return protocol::handshake(connection, "coupler", protocol::End::kClient, trust.secret);
  });
  print_line("program",
             fmt::format("{} {}, protocol {}, frames up to {}", hello.program(), hello.release(),
                         hello.protocol_version(), memory(static_cast<double>(hello.max_frame_bytes()))));
  return hello;
}

std::string microseconds(double seconds) {
  return fmt::format("{:.{}f} µs", 1e6 * seconds, seconds < 1e-4 ? 1 : 0);
}

void print(const Exchange& exchange) {
  print_line("round trip", fmt::format("{} median, 95 % within {}; {} steps of {} coupling points, without "
                                       "what the server computes",
                                       microseconds(exchange.median), microseconds(exchange.most),
                                       grouped(exchange.steps), exchange.points));
  print_line("bytes a step",
             fmt::format("{:.0f} sent, {:.0f} received", exchange.bytes_sent, exchange.bytes_received));
  print_line("steps a second",
             fmt::format("at most {} = 1 / round trip; what servers compute adds to it, which "
                         "coupler check SCENE measures",
                         grouped(static_cast<std::uint64_t>(1 / exchange.median))));
}

// Our servers say by their names what they compute; of others, both are tried.
std::vector<Role> roles_of(const wire::Hello& hello) {
  std::vector<Role> roles;
  for (const Role role : {Role::kContinuum, Role::kParticles})
    if (hello.program() == program_of(role)) roles = {role};
  return roles.empty() ? std::vector{Role::kContinuum, Role::kParticles} : roles;
}

// A server that has a secret says only now that it is busy.
Exchange measure(std::unique_ptr<protocol::Connection> connection, const wire::Hello& hello,
                 const protocol::Address& address, const Trust& trust, std::size_t points) {
  std::vector<Role> roles = roles_of(hello);
  while (true) {
    try {
      return measure_exchange(std::move(connection), roles.front(), points);
    } catch (const protocol::UserError&) {
      if (roles.size() == 1) throw;
      roles.erase(roles.begin());
      connection = protocol::connect(address, hello.program(), {}, trust.tls);
      protocol::handshake(*connection, "coupler", protocol::End::kClient, trust.secret);
    }
  }
}

}  // namespace

void doctor(const std::string& text, const TrustFiles& files, std::size_t points) {
  const protocol::Address address = protocol::parse_address(text);
  const Trust trust(files);
  auto connection = reach(address);
  secure(*connection, trust, address);
  const wire::Hello hello = greet(*connection, trust);
  const Exchange exchange =
      tell("serves", [&] { return measure(std::move(connection), hello, address, trust, points); });
  print_line("serves",
             trust.secret.empty() ? "now, without a secret" : "now, by a secret that both ends know");
  print(exchange);
}

}  // namespace adit::coupler

#include "protocol/wire/greeting.hpp"

#include <fmt/format.h>

#include <boost/asio/connect.hpp>

#include "protocol/errors.hpp"
#include "protocol/release.hpp"

namespace adit::protocol {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

[[noreturn]] void throw_other_version(const Connection& connection, std::string_view program,
                                      std::uint32_t version, const std::string& peer_program) {
  throw UserError(
      "", fmt::format("{} ({}) speaks protocol version {}, {} {} speaks version {}: install the "
                      "same release of both",
                      peer_program, connection.peer(), version, program, release(), kProtocolVersion));
}

std::uint32_t receive_preamble(Connection& connection) {
  try {
    return connection.receive_preamble();
  } catch (const ForeignPreamble& error) {
    throw UserError("", fmt::format("{} {}: another program is at that address; check host and port",
                                    connection.peer(), error.what()));
  }
}

// The name of a peer of another version, for the error message. Its hello may be unreadable, which must not
// hide the message.
std::string program_of_other_version(Connection& connection) {
  try {
    wire::Frame frame;
    connection.receive(frame, connection.patience().connect);
    return frame.hello().program() + " " + frame.hello().release();
  } catch (const std::exception&) {
    return "the other end";
  }
}

}  // namespace

std::unique_ptr<Connection> connect(const Address& address, std::string_view program,
                                    const Patience& patience) {
  asio::io_context io;
  tcp::resolver resolver(io);
  tcp::socket socket(io);
  bool found = false;
  // Both steps are asynchronous, because the blocking calls have no deadline. This error stays if the
  // deadline comes first.
  error_code error = asio::error::timed_out;
  resolver.async_resolve(address.host, std::to_string(address.port),
                         [&](const error_code& outcome, const tcp::resolver::results_type& endpoints) {
                           found = !outcome;
                           error = outcome ? outcome : error;
                           if (!found) return;
                           asio::async_connect(
                               socket, endpoints,
                               [&](const error_code& result, const tcp::endpoint&) { error = result; });
                         });
  io.run_for(patience.connect);
  if (!error) {
    auto connection = std::make_unique<Connection>(std::move(socket), program, patience);
    connection->expect_answers();
    return connection;
  }

  const std::string where = to_string(address);
  if (error == asio::error::timed_out) {
    throw UserError(
        "", fmt::format("{} does not answer at {} within {:g} s: check the address and the firewall", program,
                        where, std::chrono::duration<double>(patience.connect).count()));
  }
  if (!found) {
    throw UserError("",
                    fmt::format("the host in {} is not known ({}): check its name", where, error.message()));
  }
  throw UserError("", fmt::format("nothing listens at {} ({}): start `{} --listen {}` there, or check the "
                                  "address",
                                  where, error.message(), program, where));
}

wire::Hello handshake(Connection& connection, std::string_view program) {
  wire::Frame frame;
  auto& hello = *frame.mutable_hello();
  hello.set_protocol_version(kProtocolVersion);
  hello.set_program(std::string(program));
  hello.set_release(std::string(release()));
  hello.set_max_frame_bytes(kMaxFrameBytes);
  // This end sends before it reads, as the other one does, so neither waits for the other. The version comes
  // before hello, which another version may write differently.
  connection.send_preamble();
  connection.send(frame);

  const std::uint32_t version = receive_preamble(connection);
  if (version != kProtocolVersion) {
    throw_other_version(connection, program, version, program_of_other_version(connection));
  }
  connection.receive(frame, connection.patience().connect);
  if (!frame.has_hello()) throw PeerLost(connection.peer(), "did not begin with hello");
  connection.establish(frame.hello().max_frame_bytes());
  return frame.hello();
}

}  // namespace adit::protocol

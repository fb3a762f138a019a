#include "protocol/wire/greeting.hpp"

#include <fmt/format.h>

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <chrono>

#include "protocol/errors.hpp"
#include "protocol/release.hpp"
#include "protocol/wire/resolve.hpp"

namespace adit::protocol {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

[[noreturn]] void throw_other_version(const Connection& connection, std::string_view program,
                                      std::uint32_t version, const std::string& peer_program) {
  throw UserError(
      "", fmt::format("{} ({}) speaks protocol version {}, {} {} speaks version {}: install the "
                      "same release of both",
                      peer_program, connection.peer(), version, program, release(), kProtocolVersion));
}

// Returns the version of the other end. This end sends before it reads, as the other one does, so neither
// waits for the other. The version comes before hello, which another version may write differently.
std::uint32_t greet(Connection& connection, const wire::Frame& hello) {
  try {
    connection.send_preamble();
    connection.send(hello);
    return connection.receive_preamble();
  } catch (const ForeignPreamble& error) {
    throw UserError("", fmt::format("{} {}: another program is at that address; check host and port",
                                    connection.peer(), error.what()));
  }
}

std::string name_of(const wire::Hello& hello) {
  return hello.program() + " " + hello.release();
}

// The name of a peer of another version, for the error message. Its hello may be unreadable, which must not
// hide the message.
std::string program_of_other_version(Connection& connection) {
  try {
    wire::Frame frame;
    connection.receive(frame, connection.patience().connect);
    return name_of(frame.hello());
  } catch (const std::exception&) {
    return "the other end";
  }
}

// The secret is asked for by a challenge. A client that lacks it says so itself, because it knows its user.
void require_same_trust(const Connection& connection, End end, const Challenges& challenges) {
  if (challenges.of_client.empty() == challenges.of_server.empty()) return;
  if (end == End::kServer)
    throw UserError(
        "", connection.peer() +
                (challenges.of_client.empty() ? " has no secret" : " has a secret, but this server none"));
  throw UserError("",
                  connection.peer() + (challenges.of_client.empty()
                                           ? " serves only clients that know its secret: give "
                                             "the file of the secret by --secret-file"
                                           : " has no secret: start it with --secret-file, or run without"));
}

void send_proof(Connection& connection, std::string_view secret, End end, const Challenges& challenges) {
  wire::Frame frame;
  frame.mutable_proof()->set_hmac(prove(secret, end, challenges));
  connection.send(frame);
}

void require_proof(Connection& connection, std::string_view secret, End prover,
                   const Challenges& challenges) {
  wire::Frame frame;
  connection.receive(frame, connection.patience().connect);
  if (same_proof(frame.proof().hmac(), prove(secret, prover, challenges))) return;
  if (prover == End::kClient) refuse(connection, "its secret is another one; use the same file at both ends");
  throw UserError("", connection.peer() + " does not know the secret");
}

// The client proves first, so that the server says nothing about the secret to strangers.
void authenticate(Connection& connection, End end, std::string_view secret, const Challenges& challenges) {
  require_same_trust(connection, end, challenges);
  if (secret.empty()) return;
  if (end == End::kClient) {
    send_proof(connection, secret, End::kClient, challenges);
    require_proof(connection, secret, End::kServer, challenges);
  } else {
    require_proof(connection, secret, End::kClient, challenges);
    send_proof(connection, secret, End::kServer, challenges);
  }
}

}  // namespace

void secure_server(Connection& server, const Tls& tls, const std::string& name) {
  try {
    server.secure(tls, End::kClient, name);
  } catch (const NoTls& error) {
    throw UserError(
        "", fmt::format("{} {}: start it with --tls, or connect without", server.peer(), error.what()));
  }
}

void secure_client(Connection& client, const Tls& tls) {
  try {
    client.secure(tls, End::kServer);
  } catch (const NoTls& error) {
    client.send_preamble();
    refuse(client, "it speaks TLS only: give the folder of this machine's certificate by --tls");
    throw UserError("", client.peer() + " " + error.what());
  }
}

void refuse(Connection& connection, const std::string& reason) {
  wire::Frame frame;
  frame.mutable_error()->set_kind(wire::Error::REFUSED);
  frame.mutable_error()->set_message(reason);
  connection.send(frame);
}

std::unique_ptr<Connection> connect(const Address& address, std::string_view program,
                                    const Patience& patience, const std::optional<Tls>& tls) {
  const auto deadline = std::chrono::steady_clock::now() + patience.connect;
  const std::string where = to_string(address),
                    limit = fmt::format("{:g} s", std::chrono::duration<double>(patience.connect).count());
  error_code error;
  const Endpoints endpoints = resolve(address, patience.connect, error);
  if (error == asio::error::timed_out)
    throw UserError(
        "", fmt::format("the host in {} is not known, because no name server answers within {}: check "
                        "its name and the network",
                        where, limit));
  if (error)
    throw UserError("",
                    fmt::format("the host in {} is not known ({}): check its name", where, error.message()));
  asio::io_context io;
  Socket socket(io);
  // Asynchronous, because the blocking call has no deadline. This error stays if the deadline comes first.
  error = asio::error::timed_out;
  asio::async_connect(socket, endpoints, [&](const error_code& result, const Endpoint&) { error = result; });
  io.run_until(deadline);
  if (!error) {
    auto connection = std::make_unique<Connection>(std::move(socket), std::string(program), patience);
    connection->expect_answers();
    if (tls && address.path.empty()) secure_server(*connection, *tls, address.host);
    return connection;
  }

  if (error == asio::error::timed_out)
    throw UserError("", fmt::format("{} does not answer at {} within {}: check the address and the firewall",
                                    program, where, limit));
  if (error == asio::error::access_denied)
    throw UserError("",
                    fmt::format("this user may not connect to {}: its owner alone may, unless he lets others "
                                "write to that file",
                                where));
  throw UserError("", fmt::format("nothing listens at {} ({}): start {} there with --listen {}, or check "
                                  "the address",
                                  where, error.message(), program, where));
}

wire::Hello handshake(Connection& connection, std::string_view program, End end, const std::string& secret,
                      const std::vector<std::string>& computes) {
  const std::string challenge = secret.empty() ? "" : random_challenge();
  wire::Frame frame;
  auto& hello = *frame.mutable_hello();
  hello.set_protocol_version(kProtocolVersion);
  hello.set_program(std::string(program));
  hello.set_release(std::string(release()));
  hello.set_max_frame_bytes(kMaxFrameBytes);
  hello.set_reads_parts(true);
  hello.set_challenge(challenge);
  hello.mutable_computes()->Add(computes.begin(), computes.end());
  const std::uint32_t version = greet(connection, frame);
  if (version != kProtocolVersion) {
    throw_other_version(connection, program, version, program_of_other_version(connection));
  }
  connection.receive(frame, connection.patience().connect);
  if (!frame.has_hello()) throw PeerLost(connection.peer(), "did not begin with hello");
  const wire::Hello other = frame.hello();
  if (other.protocol_version() != kProtocolVersion)
    throw_other_version(connection, program, other.protocol_version(), name_of(other));
  if (other.max_frame_bytes() < kMaxHelloBytes)
    throw PeerLost(connection.peer(), fmt::format("accepts frames of {} bytes only; every end must accept {}",
                                                  other.max_frame_bytes(), kMaxHelloBytes));
  authenticate(connection, end, secret,
               end == End::kClient ? Challenges{challenge, other.challenge(), connection.channel()}
                                   : Challenges{other.challenge(), challenge, connection.channel()});
  connection.establish(other);
  return other;
}

}  // namespace adit::protocol

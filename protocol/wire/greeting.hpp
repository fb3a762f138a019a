// The beginning of a conversation: one end connects, then both say who they are.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/trust/secret.hpp"
#include "protocol/wire/address.hpp"
#include "protocol/wire/connection.hpp"

namespace adit::protocol {

// Connects to the server `program`, by TLS if `tls` is given and the address can lie beyond this machine.
// Throws UserError if nothing listens or answers at the address, or one end does not accept the other's
// certificate.
std::unique_ptr<Connection> connect(const Address& address, std::string_view program,
                                    const Patience& patience = {}, const std::optional<Tls>& tls = {});

// The client's part of TLS, which connect() does where it has `tls`: the server is the machine `name`. Throws
// UserError if it speaks without TLS, or one end does not accept the other's certificate.
void secure_server(Connection& server, const Tls& tls, const std::string& name);

// The server's part of TLS. A client that speaks Adit without TLS is told so; throws UserError.
void secure_client(Connection& client, const Tls& tls);

// Exchanges preamble and hello. Both ends do the same, and neither waits for the other to begin. With a
// `secret`, each end then proves that it knows it, the client first. Afterwards frames may be as long as both
// accept, and heartbeats are sent. `program` names this end, and `computes` says what a participant computes
// (Hello in wire.proto); the hello returned describes the other. Throws
// UserError if the peer has another protocol version, is another program or has another secret.
wire::Hello handshake(Connection& connection, std::string_view program, End end = End::kClient,
                      const std::string& secret = "", const std::vector<std::string>& computes = {});

// Tells a client why it is not served.
void refuse(Connection& connection, const std::string& reason);

}  // namespace adit::protocol

// The beginning of a conversation: one end connects, then both say who they are.
#pragma once

#include <memory>
#include <string_view>

#include "protocol/wire/address.hpp"
#include "protocol/wire/connection.hpp"

namespace adit::protocol {

// Connects to the server `program`. Throws UserError if nothing listens or answers at the address.
std::unique_ptr<Connection> connect(const Address& address, std::string_view program,
                                    const Patience& patience = {});

// Exchanges preamble and hello. Both ends do the same, and neither waits for the other to begin. Afterwards
// frames may be as long as both accept, and heartbeats are sent. `program` names this end; the hello returned
// describes the other. Throws UserError if the peer has another protocol version or is another program.
wire::Hello handshake(Connection& connection, std::string_view program);

}  // namespace adit::protocol

// How a conversation begins: connect, then both ends say who they are.
#pragma once

#include <memory>
#include <string_view>

#include "protocol/wire/address.hpp"
#include "protocol/wire/connection.hpp"

namespace adit::protocol {

// Connects to a server, `program`. An address where nothing listens, or nobody answers, is a UserError.
std::unique_ptr<Connection> connect(const Address& address, std::string_view program,
                                    const Patience& patience = {});

// Exchanges preamble and hello; both ends do the same, and neither waits for the other to begin. Afterwards
// frames may be as long as both accept, and heartbeats go out. `program` is who we are; the answer is who
// they are. A peer of another protocol version, or that does not speak the protocol, is a UserError.
wire::Hello handshake(Connection& connection, std::string_view program);

}  // namespace adit::protocol

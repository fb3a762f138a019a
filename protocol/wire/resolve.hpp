// The endpoints that an address stands for, within a deadline; and the address of an endpoint.
#pragma once

#include <boost/asio/generic/stream_protocol.hpp>
#include <chrono>
#include <functional>
#include <vector>

#include "protocol/wire/address.hpp"

namespace adit::protocol {

using Endpoint = boost::asio::generic::stream_protocol::endpoint;  // of TCP or of a Unix socket
using Endpoints = std::vector<Endpoint>;
using Lookup = std::function<Endpoints(const Address&, boost::system::error_code&)>;

Endpoints look_up(const Address& address,
                  boost::system::error_code& error);  // by the system, which has no deadline

// `error` is timed_out at the deadline. Nothing ends a lookup whose name server is silent: it goes on in a
// thread of its own, which is left behind.
Endpoints resolve(const Address& address, std::chrono::milliseconds within, boost::system::error_code& error,
                  const Lookup& lookup = look_up);

Address address_of(const Endpoint& endpoint);  // host and port as numbers

}  // namespace adit::protocol

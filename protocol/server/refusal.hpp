// Sends a client away, with the reason.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <string>

namespace adit::protocol {

// Says REFUSED with `reason` and closes, once the client has read it or a short time has passed; returns at
// once, the rest happens where the socket's handlers run.
void refuse(boost::asio::ip::tcp::socket socket, const std::string& reason);

}  // namespace adit::protocol

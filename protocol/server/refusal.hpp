// Sends a client away, with the reason.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <string>

namespace adit::protocol {

// Sends REFUSED with `reason`, and closes the socket once the client has read it or a short time has passed.
// Returns at once; the rest happens in the thread that runs the socket's handlers.
void refuse(boost::asio::ip::tcp::socket socket, const std::string& reason);

}  // namespace adit::protocol

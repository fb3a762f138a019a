#include "protocol/server/refusal.hpp"

#include <array>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <memory>
#include <span>
#include <utility>

#include "protocol/wire/frame.hpp"

namespace adit::protocol {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

constexpr std::chrono::seconds kFarewell{2};  // time for the client to read the reason

wire::Frame refused(const std::string& reason) {
  wire::Frame frame;
  frame.mutable_error()->set_kind(wire::Error::REFUSED);
  frame.mutable_error()->set_message(reason);
  return frame;
}

asio::const_buffer buffer(std::span<const std::byte> bytes) {
  return {bytes.data(), bytes.size()};
}

// One refusal, which lives as long as one of its handlers waits. What the client sends is read and dropped,
// because closing a socket with unread bytes resets the connection, and the reason might not arrive.
struct Refusal : std::enable_shared_from_this<Refusal> {
  tcp::socket socket;
  asio::steady_timer timer;
  Preamble preamble = encode_preamble();
  FrameEncoder encoder;
  std::array<asio::const_buffer, 2> bytes;
  std::array<std::byte, 4096> dropped;

  Refusal(tcp::socket&& client, const std::string& reason)
      : socket(std::move(client)),
        timer(socket.get_executor(), kFarewell),
        bytes{buffer(preamble), buffer(encoder.encode(refused(reason), kMaxHelloBytes))} {}

  void start() {
    timer.async_wait([self = shared_from_this()](const error_code&) {
      error_code ignored;
      self->socket.close(ignored);
    });
    asio::async_write(socket, bytes, [self = shared_from_this()](const error_code&, std::size_t) {
      error_code ignored;
      // The client reads the end of the stream after the reason and closes, which ends drop().
      self->socket.shutdown(tcp::socket::shutdown_send, ignored);
      self->drop();
    });
  }

  void drop() {
    socket.async_read_some(asio::buffer(dropped),
                           [self = shared_from_this()](const error_code& error, std::size_t) {
                             if (error) {
                               self->timer.cancel();
                             } else {
                               self->drop();
                             }
                           });
  }
};

}  // namespace

void refuse(tcp::socket socket, const std::string& reason) {
  std::make_shared<Refusal>(std::move(socket), reason)->start();
}

}  // namespace adit::protocol

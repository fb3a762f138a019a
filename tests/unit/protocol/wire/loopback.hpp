// Sockets on loopback for the tests of the transport.
#pragma once

#include <gtest/gtest.h>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "protocol/errors.hpp"
#include "protocol/wire/connection.hpp"
#include "protocol/wire/frame.hpp"
#include "protocol/wire/greeting.hpp"

namespace adit::protocol {

using boost::asio::ip::tcp;

// A pair of connected sockets; `near` is meant for a Connection, `far` for whatever the test puts there.
struct SocketPair {
  boost::asio::io_context io;
  tcp::socket near{io};
  tcp::socket far{io};

  SocketPair() {
    tcp::acceptor acceptor(io, tcp::endpoint(boost::asio::ip::address_v4::loopback(), 0));
    near.connect(acceptor.local_endpoint());
    acceptor.accept(far);
  }
};

// What the peer at `far` sends as raw bytes.
inline void write_raw(tcp::socket& socket, std::span<const std::byte> bytes) {
  boost::asio::write(socket, boost::asio::buffer(bytes.data(), bytes.size()));
}

inline void write_frame(tcp::socket& socket, const wire::Frame& frame) {
  FrameEncoder encoder;
  write_raw(socket, encoder.encode(frame, kMaxFrameBytes));
}

// Of a peer of an earlier release.
inline wire::Hello hello_without_parts() {
  wire::Hello hello;
  hello.set_program("dem_server");
  hello.set_release("0.4.0");
  hello.set_max_frame_bytes(kMaxFrameBytes);
  return hello;
}

// Two connections that have greeted each other.
struct ConnectionPair {
  SocketPair sockets;
  Connection near;
  Connection far;

  explicit ConnectionPair(const Patience& near_patience = {}, const Patience& far_patience = {})
      : near(std::move(sockets.near), "dem_server", near_patience),
        far(std::move(sockets.far), "coupler", far_patience) {
    std::thread other([this] { handshake(far, "dem_server"); });
    handshake(near, "coupler");
    other.join();
  }
};

// The message of the error of type E that `action` throws; fails the test when it throws none.
template <class E, class Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const E& error) {
    return error.what();
  }
  ADD_FAILURE() << "no error of the expected type";
  return "";
}

}  // namespace adit::protocol

// One end of a conversation: frames over a TCP socket, with a deadline on every wait.
//
// A wait first spins, yielding the core between two looks at the socket, and then sleeps. A wake-up from
// sleep takes longer than a whole round trip, and short steps avoid it by spinning (connection.cpp: kSpin).
// An end that has nothing else to send sends heartbeats. Silence therefore means that the peer is lost, and a
// long computation is not mistaken for it.
#pragma once

#include <array>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "protocol/messages/wire.pb.h"
#include "protocol/wire/frame.hpp"
#include "protocol/wire/heartbeat.hpp"

namespace adit::protocol {

struct Patience {
  std::chrono::milliseconds silence = std::chrono::seconds(8);  // longest time without a byte from the peer
  std::chrono::milliseconds answer =
      std::chrono::minutes(10);  // longest wait for one frame, peer alive or not
  std::chrono::milliseconds connect = std::chrono::seconds(5);  // for connecting, and for each greeting
  std::chrono::milliseconds heartbeat =
      std::chrono::seconds(1);  // longest time in which this end sends nothing
};

struct Traffic {
  std::uint64_t bytes_sent = 0;
  std::uint64_t bytes_received = 0;
  double seconds_waited = 0;  // time spent waiting for frames
};

// Used by one thread; only interrupt() may be called from others. Every function throws PeerLost, which names
// the peer ("dem_server at 127.0.0.1:4711"), if the peer is gone, silent or sends bytes that cannot be read.
class Connection {
 public:
  // Takes over a connected socket; `program` names the program expected at the other end.
  Connection(boost::asio::ip::tcp::socket&& socket, std::string_view program, const Patience& patience);
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  const std::string& peer() const { return peer_; }
  const Patience& patience() const { return patience_; }
  Traffic traffic() const;

  // Sends one frame in one write. Waits for a peer that does not read as long as it shows signs of life.
  // Throws std::length_error if the frame is longer than the peer accepts.
  void send(const wire::Frame& frame);

  // Receives the next frame that is not a heartbeat, reusing the memory of `frame`. An error frame is thrown
  // as an exception (error_frame.hpp).
  void receive(wire::Frame& frame) { receive(frame, patience_.answer); }
  void receive(wire::Frame& frame, std::chrono::milliseconds within);

  // Says that this end asks and the other answers. The duration of a wait is then predicted from the last
  // ones.
  void expect_answers() { forecasts_ = true; }

  // The parts of the greeting (greeting.hpp): both preambles, then the frame length that hello agreed on.
  // Heartbeats are sent from establish() on.
  void send_preamble();
  std::uint32_t receive_preamble();
  void establish(std::uint64_t peer_accepts_bytes);

  // Ends the conversation and leaves the peer time to read what was sent last: sends no more, and drops what
  // arrives until the peer closes too or kFarewell has passed. Never throws.
  void close();

  // Ends all traffic, from any thread; a waiting call then finds the connection closed.
  void interrupt();

 private:
  using Clock = std::chrono::steady_clock;
  using Socket = boost::asio::ip::tcp::socket;
  class Watch;

  template <class Take>
  void await(Take take_complete, std::chrono::milliseconds within);
  bool take(wire::Frame& frame);
  Clock::duration expected_wait() const;
  bool read_some();
  void write(std::span<const std::byte> bytes);
  void sleep(Clock::time_point until, bool readable, bool writable);
  [[noreturn]] void throw_closed(const boost::system::error_code& error);
  void beat();

  std::string peer_;
  Patience patience_;
  boost::asio::io_context io_{1};
  Socket socket_{io_};
  FrameDecoder decoder_;
  std::uint64_t bytes_received_ = 0;
  Clock::duration waited_{};
  bool forecasts_ = false;
  std::array<Clock::duration, 4> last_waits_{};
  std::size_t waits_ = 0;
  int waits_without_spin_ = 0;

  std::mutex sending_;  // the frames of the owner and the heartbeats go out one after another
  FrameEncoder encoder_;
  std::uint64_t send_limit_ = kMaxHelloBytes;
  std::span<const std::byte> rest_of_heartbeat_;  // bytes that the socket did not take yet
  std::atomic<std::uint64_t> bytes_sent_ = 0;
  std::uint64_t bytes_sent_at_last_beat_ = 0;
  std::optional<Heartbeat>
      heartbeat_;  // the last member, so that its thread ends before the others are destroyed
};

}  // namespace adit::protocol

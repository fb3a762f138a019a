// One end of a conversation: frames over a TCP socket, with a deadline on every wait.
//
// A wait first spins, yielding the core between two looks at the socket, and then sleeps: a wake-up costs
// more than a whole round trip, so steps shorter than the spin never pay for one (connection.cpp: kSpin).
// Both ends send a heartbeat when they have nothing else to say, so that silence means death and a long
// computation does not.
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
  std::chrono::milliseconds silence = std::chrono::seconds(8);    // without a byte from the peer
  std::chrono::milliseconds answer = std::chrono::minutes(10);    // for one frame, alive or not
  std::chrono::milliseconds connect = std::chrono::seconds(5);    // to connect, and to greet
  std::chrono::milliseconds heartbeat = std::chrono::seconds(1);  // longest silence of ours
};

struct Traffic {
  std::uint64_t bytes_sent = 0;
  std::uint64_t bytes_received = 0;
  double seconds_waited = 0;  // for frames to arrive
};

// Used by one thread, but for interrupt(). Every function throws PeerLost, which names the peer
// ("dem_server at 127.0.0.1:4711"), when the peer is gone, silent or unintelligible.
class Connection {
 public:
  // Takes over a connected socket; `program` is what is thought to be at the other end.
  Connection(boost::asio::ip::tcp::socket&& socket, std::string_view program, const Patience& patience);
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  const std::string& peer() const { return peer_; }
  const Patience& patience() const { return patience_; }
  Traffic traffic() const;

  // One frame, in one write. Waits while the peer does not read, as long as it shows signs of life.
  // Throws std::length_error when the peer does not accept so long a frame.
  void send(const wire::Frame& frame);

  // The next frame that is not a heartbeat; the memory of `frame` is used again. An error frame is thrown
  // as error_frame.hpp says.
  void receive(wire::Frame& frame) { receive(frame, patience_.answer); }
  void receive(wire::Frame& frame, std::chrono::milliseconds within);

  // Says that this end asks and the other answers: waits are then foretold from those before.
  void expect_answers() { forecasts_ = true; }

  // The greeting (greeting.hpp): preambles, then what hello agreed on, from where on heartbeats go out.
  void send_preamble();
  std::uint32_t receive_preamble();
  void establish(std::uint64_t peer_accepts_bytes);

  // Ends the conversation so that the peer can still read what was sent last: sends no more and drops what
  // comes until the peer closes too, or a short time has passed. Never throws.
  void close();

  // From any thread: ends all traffic; whoever waits here finds the connection closed.
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
  std::span<const std::byte> rest_of_heartbeat_;  // what the socket did not take
  std::atomic<std::uint64_t> bytes_sent_ = 0;
  std::uint64_t bytes_sent_at_last_beat_ = 0;
  std::optional<Heartbeat> heartbeat_;  // last, so that its thread ends before the rest goes
};

}  // namespace adit::protocol

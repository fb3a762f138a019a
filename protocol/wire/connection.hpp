// One end of a conversation: frames over a TCP or Unix socket, or TLS on it, with a deadline on every wait.
//
// A wait first spins, yielding the core between two looks at the socket, and then sleeps. A wake-up from
// sleep takes longer than a whole round trip, and short steps avoid it by spinning (connection.cpp: kSpin).
// An end that has nothing else to send sends heartbeats. Silence therefore means that the peer is lost, and a
// long computation is not mistaken for it.
#pragma once

#include <array>
#include <atomic>
#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/io_context.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>

#include "protocol/messages/wire.pb.h"
#include "protocol/trust/tls.hpp"
#include "protocol/wire/bounds.hpp"
#include "protocol/wire/frame.hpp"
#include "protocol/wire/heartbeat.hpp"
#include "protocol/wire/parts.hpp"

namespace adit::protocol {

using Socket = boost::asio::generic::stream_protocol::socket;  // of TCP or of this machine
enum class Direction { kSent, kReceived };

struct Traffic {
  std::uint64_t bytes_sent = 0;
  std::uint64_t bytes_received = 0;
  double seconds_waited = 0;  // time spent waiting for frames
};

// Used by one thread; only interrupt() and what says so may be called from others. Every function throws
// PeerLost, which names the peer ("dem_server at 127.0.0.1:4711"), if the peer is gone, silent or sends bytes
// that cannot be read.
class Connection {
 public:
  // Takes over a connected socket; `program` names the program expected at the other end, until establish().
  Connection(Socket&& socket, const std::string& program, const Patience& patience);
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  const std::string& peer() const { return peer_; }
  const Patience& patience() const { return patience_; }
  Traffic traffic() const;

  // From now on `hear` gets the bytes of every frame, length included, as they go over the connection or into
  // TLS: before it is sent, after it was received whole; of a message in parts, one after another. Heartbeats
  // are left out. What it throws, send() and receive() throw.
  using Hear = std::function<void(Direction, std::span<const std::byte>)>;
  void overhear(Hear hear) { hear_ = std::move(hear); }

  // Sends one message: in parts where it is longer than kMaxPartBytes and the peer reads parts, else as one
  // frame in one write. A peer that shows signs of life may take as long for all of it as said. Throws
  // std::length_error if a frame is longer than the peer accepts.
  void send(const wire::Frame& frame) { send(frame, patience_.answer); }
  void send(const wire::Frame& frame, std::chrono::milliseconds within);

  // Receives the next message that is not a heartbeat, reusing the memory of `frame`. Its texts are clean
  // (content/clean_text.hpp). An error frame is thrown as an exception (content/error_frame.hpp). A peer that
  // sends what is no frame, or sends it too late or too slowly, is told so before PeerLost is thrown.
  void receive(wire::Frame& frame) { receive(frame, patience_.answer); }
  void receive(wire::Frame& frame, std::chrono::milliseconds within);

  // The longest message that is received from now on, all of its parts together.
  void accept_up_to(std::uint64_t bytes) { decoder_.set_limit(bytes); }

  // Says that this end asks and the other answers. The duration of a wait is then predicted from the last
  // ones.
  void expect_answers() { forecasts_ = true; }

  // Goes on by TLS, as `end` of it; a client says the `name` of the machine that it wants. To be called
  // before anything else is sent. Throws NoTls, or UserError if one end does not accept the other.
  void secure(const Tls& tls, End end, const std::string& name = "");
  // What the peer's certificate says of it; empty without TLS.
  std::string certificate() const { return tls_ ? tls_->certificate() : ""; }

  // What only the two ends of this TLS connection know; empty without TLS.
  std::string channel() const { return tls_ ? tls_->channel() : std::string(); }

  // The parts of the greeting (greeting.hpp): both preambles, then what hello agreed on. From establish() on
  // heartbeats are sent, and the peer has the name that it gave itself.
  void send_preamble();
  std::uint32_t receive_preamble();
  void establish(const wire::Hello& of_peer);

  // While the owner computes and does not look at the connection, `leave` is called once the peer has closed
  // it, within the interval of heartbeats and from the heartbeat's thread.
  void when_gone(std::function<void()> leave);

  // How far this end is in a long work, told with the next heartbeats until something else is sent; and what
  // the peer told last, for which any thread may ask. Who tells owns the connection: throws PeerLost where
  // the peer has been silent for too long meanwhile.
  void tell_progress(const std::string& how_far);
  std::string progress_of_peer() const;

  // Ends the conversation and leaves the peer time to read what was sent last: sends no more, and drops what
  // arrives until the peer closes too or the time for a farewell has passed. Never throws.
  void close();

  // Ends all traffic, from any thread; a waiting call then finds the connection closed.
  void interrupt();

 private:
  using Clock = std::chrono::steady_clock;
  class Watch;

  template <class Take>
  void await(Take take_complete, std::chrono::milliseconds within);
  Clock::duration expected_wait() const;
  bool take_frame(wire::Frame& frame);
  bool take(wire::Frame& frame);
  void send_frame(const wire::Frame& frame, bool goes_on, Watch& watch);
  bool read_some();
  std::size_t write_some(std::span<const std::byte> bytes, boost::system::error_code& error);
  void write(std::span<const std::byte> bytes, Watch& watch);
  void tell(const std::string& fault);
  bool peer_closed();
  void require_alive();
  void sleep(Clock::time_point until, bool readable, bool writable);
  [[noreturn]] void throw_closed(const boost::system::error_code& error);
  void tell_listener(Direction direction, std::span<const std::byte> frame);
  void beat();

  std::string place_, peer_;
  Patience patience_;
  boost::asio::io_context io_{1};
  Socket socket_{io_};
  std::mutex ending_;  // the socket is closed and interrupted one after another
  std::optional<TlsStream> tls_;
  FrameDecoder decoder_;
  Assembly assembly_;
  std::uint64_t parts_taken_ = 0;
  Hear hear_;
  std::uint64_t bytes_received_ = 0;
  std::uint64_t bytes_heard_ = 0;  // of them, when this end told its progress last
  Clock::time_point heard_;        // when it last found more of them
  Clock::duration waited_{};
  bool awaits_preamble_ = false;  // what has arrived is a part of it, and no frame
  bool forecasts_ = false;
  std::array<Clock::duration, 4> last_waits_{};
  std::size_t waits_ = 0;
  int waits_without_spin_ = 0, next_without_spin_ = 0;  // now; when a yield lasts too long

  std::mutex sending_;  // the frames of the owner and the heartbeats go out one after another
  FrameEncoder encoder_;
  std::uint64_t send_limit_ = kMaxHelloBytes;
  bool sends_parts_ = false;
  std::string peer_release_;  // as in "dem_server 0.4.0"
  std::vector<std::byte> last_heartbeat_;
  std::span<const std::byte> rest_of_heartbeat_;  // bytes that the socket did not take yet
  std::string progress_;                          // of this end
  std::atomic<std::uint64_t> bytes_sent_ = 0;
  std::uint64_t bytes_sent_at_last_beat_ = 0;
  std::function<void()> leave_;
  bool was_closed_ = false;  // by the peer, at the last beat
  mutable std::mutex hearing_;
  std::string progress_of_peer_;
  std::optional<Heartbeat>
      heartbeat_;  // the last member, so that its thread ends before the others are destroyed
};

}  // namespace adit::protocol

#include "protocol/wire/connection.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sched.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <cerrno>
#include <thread>
#include <utility>

#include "protocol/errors.hpp"
#include "protocol/release.hpp"
#include "protocol/text.hpp"
#include "protocol/wire/address.hpp"
#include "protocol/wire/content/clean_text.hpp"
#include "protocol/wire/content/error_frame.hpp"
#include "protocol/wire/resolve.hpp"

namespace adit::protocol {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

// How an end waits for a frame:
// - A thread that sleeps on the socket wakes later than a whole round trip between two spinning ends takes,
//   and pushes aside a thread that computes when it does. So a wait begins by spinning for kSpin, which is
//   longer than a step of 10^5 particles on two threads. It yields its core to whoever computes.
// - The end that asks also shortens its long waits. Answers take about as long as the last ones did, so it
//   sleeps by the clock for kNap of that time, but wakes kEarly before it, and then spins. An answer that is
//   there when it wakes came at an unknown time: half of the wait is taken for it, so that naps that are too
//   long soon become shorter. The end that answers must not nap: its waits contain the naps of the other end,
//   and each would prolong the other's.
// - An answer that is later than expected is waited for asleep.
// - If work of others needs the core, a yield lasts milliseconds. A yield longer than kLongYield is the sign
//   of that; threads of the servers, which share the cores, give it back sooner. The next waits sleep at
//   once: kFewestWithoutSpin of them, twice as many whenever this happens again, one less for each wait that
//   spins undisturbed.
constexpr std::chrono::microseconds kSpin{500}, kEarly{200}, kLongYield{2000};
constexpr double kNap = 0.8;                               // share of the expected wait
constexpr std::chrono::milliseconds kLongestForecast{50};  // a late wake-up is negligible beside longer waits
constexpr std::chrono::milliseconds kLongestSleep{60'000};
constexpr int kFewestWithoutSpin = 16, kMostWithoutSpin = 1024;

// The peer is alive, but what it sends or takes comes too late.
class Late : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

std::string seconds(std::chrono::milliseconds time) {
  return fmt::format("{:g} s", std::chrono::duration<double>(time).count());
}

// As in " at 127.0.0.1:4711"; empty where the other end has gone already.
std::string place_of_peer(const Socket& socket) {
  error_code error;
  const Endpoint end = socket.remote_endpoint(error);
  if (error) return "";
  Address address = address_of(end);
  // A client of a Unix socket has no address of its own.
  if (address.host.empty() && address.path.empty()) address = address_of(socket.local_endpoint());
  return " at " + to_string(address);
}

}  // namespace

// The deadlines of one wait: for the silence of the peer, for the wait as a whole, and for a frame that has
// begun to arrive.
class Connection::Watch {
 public:
  Watch(const Connection& connection, std::chrono::milliseconds within)
      : peer_(connection.peer_), patience_(connection.patience_), within_(within) {}

  // `arrived`: bytes of the next frame, which is not complete; `parts`: those taken of its message.
  void sign_of_life(Clock::time_point now, std::size_t arrived, std::uint64_t parts = 0) {
    heard_ = now;
    if (parts != parts_) frame_began_.reset();
    parts_ = parts;
    if (arrived == 0) {
      frame_began_.reset();
      frame_ends_ = Clock::time_point::max();
      return;
    }
    if (!frame_began_) frame_began_ = now;
    frame_ends_ = *frame_began_ + patience_.frame + std::chrono::seconds(arrived / kLeastRate);
  }
  Clock::duration quiet_for(Clock::time_point now) const { return now - heard_; }
  Clock::duration lasted(Clock::time_point now) const { return now - start_; }
  Clock::time_point deadline() const {
    return std::min({heard_ + patience_.silence, start_ + within_, frame_ends_});
  }

  // Throws PeerLost for silence, else Late.
  void check(Clock::time_point now) const {
    if (now - start_ >= within_) throw Late("no answer within " + seconds(within_));
    if (now - heard_ >= patience_.silence)
      throw PeerLost(peer_, "no sign of life for " + seconds(patience_.silence));
    if (now >= frame_ends_)
      throw Late(fmt::format("sent a frame more slowly than {} KiB/s after the first {}", kLeastRate >> 10,
                             seconds(patience_.frame)));
  }

 private:
  const std::string& peer_;
  const Patience& patience_;
  std::chrono::milliseconds within_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point heard_ = start_;
  std::uint64_t parts_ = 0;
  std::optional<Clock::time_point> frame_began_;
  Clock::time_point frame_ends_ = Clock::time_point::max();
};

Connection::Connection(Socket&& socket, const std::string& program, const Patience& patience)
    : place_(place_of_peer(socket)), peer_(program + place_), patience_(patience) {
  const auto protocol = socket.local_endpoint().protocol();
  // The socket comes from the io_context of a listener or of connect(). Here it gets one of its own, which
  // nobody runs: this object waits by itself.
  socket_.assign(protocol, socket.release());
  ::fcntl(socket_.native_handle(), F_SETFD, FD_CLOEXEC);  // for the servers that the coupler starts later
  // A frame is small and its answer is waited for; Nagle's algorithm would hold it back for more bytes.
  if (protocol.family() != AF_UNIX) socket_.set_option(asio::ip::tcp::no_delay(true));
  socket_.non_blocking(true);
  decoder_.expect_greeting(true);
  next_without_spin_ = kFewestWithoutSpin;
}

Traffic Connection::traffic() const {
  return {bytes_sent_, bytes_received_, std::chrono::duration<double>(waited_).count()};
}

void Connection::send(const wire::Frame& frame, std::chrono::milliseconds within) {
  Watch watch(*this, within);
  if (!sends_parts_ || frame.ByteSizeLong() <= kMaxPartBytes) return send_frame(frame, false, watch);
  divide(frame, kPartBytes, [&](const wire::Frame& part, bool goes_on) { send_frame(part, goes_on, watch); });
}

void Connection::send_frame(const wire::Frame& frame, bool goes_on, Watch& watch) {
  const std::lock_guard lock(sending_);
  if (!sends_parts_ && !peer_release_.empty() && frame.ByteSizeLong() > send_limit_)
    throw std::length_error(fmt::format(
        "a message of {} bytes is longer than the {} that {} accepts, which reads no messages in parts as "
        "release {} does; take the same release at both ends, or a smaller model",
        frame.ByteSizeLong(), send_limit_, peer_release_, release()));
  const auto bytes = encoder_.encode(frame, send_limit_, goes_on);
  tell_listener(Direction::kSent, bytes);
  write(rest_of_heartbeat_, watch);
  rest_of_heartbeat_ = {};
  write(bytes, watch);
  progress_.clear();
}

// False if bytes are missing.
bool Connection::take_frame(wire::Frame& frame) {
  const bool complete = decoder_.take(frame);
  if (decoder_.progress() != progress_of_peer_) {
    const std::lock_guard lock(hearing_);
    progress_of_peer_ = decoder_.progress();
  }
  return complete;
}

// False until the last part has arrived.
bool Connection::take(wire::Frame& frame) {
  while (take_frame(frame)) {
    tell_listener(Direction::kReceived, decoder_.taken());
    ++parts_taken_;
    if (assembly_.add(frame, decoder_.goes_on())) return true;
  }
  return false;
}

void Connection::receive(wire::Frame& frame, std::chrono::milliseconds within) {
  const auto lose = [this](const std::exception& fault) {
    tell(fault.what());
    throw PeerLost(peer_, fault.what());
  };
  try {
    await([&] { return take(frame); }, within);
  } catch (const Malformed& fault) {
    lose(fault);
  } catch (const Late& fault) {
    lose(fault);
  }
  clean_text(frame);
  if (frame.has_error()) throw_error(peer_, frame.error());
}

void Connection::tell_listener(Direction direction, std::span<const std::byte> frame) {
  if (hear_) hear_(direction, frame);
}

void Connection::secure(const Tls& tls, End end, const std::string& name) {
  tls_.emplace(tls, end, socket_.native_handle(), name, peer_);
  const Watch watch(*this, patience_.connect);
  try {
    for (auto next = tls_->handshake(); next != TlsStream::Next::kNothing; next = tls_->handshake()) {
      watch.check(Clock::now());
      sleep(watch.deadline(), next == TlsStream::Next::kRead, next == TlsStream::Next::kWrite);
    }
  } catch (const Late& fault) {
    throw PeerLost(peer_, fault.what());
  } catch (const NoTls&) {
    tls_.reset();
    throw;
  }
}

void Connection::send_preamble() {
  const std::lock_guard lock(sending_);
  Watch watch(*this, patience_.connect);
  awaits_preamble_ = true;
  write(encode_preamble(), watch);
}

std::uint32_t Connection::receive_preamble() {
  std::optional<std::uint32_t> version;
  try {
    await([&] { return (version = decoder_.take_preamble()).has_value(); }, patience_.connect);
  } catch (const Late& fault) {
    throw PeerLost(peer_, fault.what());
  }
  awaits_preamble_ = false;
  return *version;
}

void Connection::when_gone(std::function<void()> leave) {
  const std::lock_guard lock(sending_);
  leave_ = std::move(leave);
}

void Connection::tell_progress(const std::string& how_far) {
  {
    const std::lock_guard lock(sending_);
    progress_ = how_far;
  }
  require_alive();
}

// Nobody waits for the peer, but it beats: only one that has stopped is silent. What has arrived stays for
// the next wait, up to a limit, at which nothing is judged.
void Connection::require_alive() {
  const bool full = decoder_.buffered() >= kMaxHelloBytes;
  if (!full) read_some();
  const auto now = Clock::now();
  if (full || std::exchange(bytes_heard_, bytes_received_) != bytes_received_) heard_ = now;
  if (now - heard_ > patience_.silence)
    throw PeerLost(peer_, fmt::format("sent nothing for {} s",
                                      std::chrono::ceil<std::chrono::seconds>(patience_.silence).count()));
}

std::string Connection::progress_of_peer() const {
  const std::lock_guard lock(hearing_);
  return progress_of_peer_;
}

// The fault of the peer, so that it can tell its user, as far as it reads it at once; then closes.
void Connection::tell(const std::string& fault) {
  wire::Frame frame;
  frame.mutable_error()->set_kind(wire::Error::REQUEST);
  frame.mutable_error()->set_message(peer_ + ": " + fault);
  try {
    send(frame, patience_.farewell);
  } catch (const std::exception&) {  // it is lost anyhow
  }
  close();
}

void Connection::establish(const wire::Hello& of_peer) {
  decoder_.expect_greeting(false);
  decoder_.set_limit(kMaxFrameBytes);
  sends_parts_ = of_peer.reads_parts() && of_peer.max_frame_bytes() >= kMaxPartBytes;
  if (sends_parts_) decoder_.accept_parts(kMaxPartBytes);
  send_limit_ = sends_parts_ ? kMaxPartBytes : std::min(of_peer.max_frame_bytes(), kMaxFrameBytes);
  if (!of_peer.program().empty()) peer_ = shorten(of_peer.program()) + place_;
  peer_release_ = fmt::format("{} {}", of_peer.program(), of_peer.release());
  // The heartbeat looks twice in an interval, so that an end is never silent for longer than the interval.
  heartbeat_.emplace(patience_.heartbeat / 2, [this] { beat(); });
}

// Reads until `take_complete` finds a complete item among the bytes that have arrived.
template <class Take>
void Connection::await(Take take_complete, std::chrono::milliseconds within) {
  if (take_complete()) return;
  Watch watch(*this, within);
  const bool may_spin = waits_without_spin_ == 0;
  if (!may_spin) --waits_without_spin_;
  const Clock::duration expected = may_spin ? expected_wait() : Clock::duration::zero();
  const auto nap = std::min(std::chrono::duration_cast<Clock::duration>(kNap * expected), expected - kEarly);
  bool just_woken = nap > kEarly;
  if (just_woken) std::this_thread::sleep_for(nap);
  const Clock::duration spin = may_spin ? expected + kSpin : Clock::duration::zero();
  while (true) {
    // The deadlines are checked after reading, so that bytes that have arrived in time count.
    const bool arrived = read_some();
    const auto now = Clock::now();
    if (arrived && take_complete()) {
      if (may_spin && waits_without_spin_ == 0)
        next_without_spin_ = std::max(next_without_spin_ - 1, kFewestWithoutSpin);
      waited_ += watch.lasted(now);
      last_waits_[waits_++ % last_waits_.size()] = watch.lasted(now) / (just_woken ? 2 : 1);
      return;
    }
    if (!arrived) just_woken = false;
    if (arrived) watch.sign_of_life(now, decoder_.buffered(), parts_taken_);
    watch.check(now);
    if (arrived) continue;  // TLS may hold more that has arrived
    if (watch.quiet_for(now) < spin) {
      sched_yield();
      if (waits_without_spin_ == 0 && Clock::now() - now > kLongYield) {
        waits_without_spin_ = next_without_spin_;
        next_without_spin_ = std::min(2 * next_without_spin_, kMostWithoutSpin);
      }
    } else {
      sleep(watch.deadline(), true, false);
    }
  }
}

// The shortest of the last waits, because a wait that was delayed by chance says nothing about the next one.
Connection::Clock::duration Connection::expected_wait() const {
  if (!forecasts_) return Clock::duration::zero();
  const auto shortest = *std::min_element(last_waits_.begin(), last_waits_.end());
  return shortest < kLongestForecast ? shortest : Clock::duration::zero();
}

// Reads the bytes that have arrived; false if there are none.
bool Connection::read_some() {
  const auto space = decoder_.space();
  error_code error;
  const std::size_t count = tls_ ? tls_->read_some(space, error)
                                 : socket_.read_some(asio::buffer(space.data(), space.size()), error);
  if (error == asio::error::would_block) return false;
  if (error) throw_closed(error);
  decoder_.arrived(count);
  bytes_received_ += count;
  return true;
}

// Also called by the heartbeat's thread, which may not use the socket object.
std::size_t Connection::write_some(std::span<const std::byte> bytes, error_code& error) {
  if (tls_) return tls_->write_some(bytes, error);
  const auto count = ::send(socket_.native_handle(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
  error = count < 0 ? error_code(errno, boost::system::system_category()) : error_code();
  return count < 0 ? 0 : static_cast<std::size_t>(count);
}

// If the peer takes no bytes, this end keeps reading up to a limit. So it sees the peer's heartbeats, or the
// error for which the peer stopped reading.
void Connection::write(std::span<const std::byte> bytes, Watch& watch) {
  bool alive = false;
  while (!bytes.empty()) {
    error_code error;
    const std::size_t count = write_some(bytes, error);
    if (!error) {
      bytes = bytes.subspan(count);
      bytes_sent_ += count;
      alive = true;
      continue;
    }
    const bool may_read = decoder_.buffered() < kMaxHelloBytes;
    if (may_read && read_some()) alive = true;
    if (error != asio::error::would_block) throw_closed(error);
    const auto now = Clock::now();
    if (std::exchange(alive, false)) watch.sign_of_life(now, 0);
    try {
      watch.check(now);
    } catch (const Late&) {
      throw PeerLost(peer_, "did not read what was sent to it");
    }
    sleep(watch.deadline(), may_read, true);
  }
}

// Sleeps until the socket is readable or writable, as asked, or until the given time. By poll(): async_wait()
// of Boost.Asio 1.74 ends at once, again and again, on a socket that had to wait for room to write before.
void Connection::sleep(Clock::time_point until, bool readable, bool writable) {
  const auto events = static_cast<short>((readable ? POLLIN : 0) | (writable ? POLLOUT : 0));
  pollfd waited{socket_.native_handle(), events, 0};
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
  ::poll(&waited, 1, static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, kLongestSleep.count())));
}

// Before it closed the connection, the peer may have sent an error that says why; that error is then thrown.
void Connection::throw_closed(const error_code& error) {
  wire::Frame last;
  if (awaits_preamble_) awaits_preamble_ = !decoder_.take_preamble();
  try {
    while (!awaits_preamble_ && decoder_.take(last)) {
      tell_listener(Direction::kReceived, decoder_.taken());
      clean_text(last);
      if (last.has_error()) throw_error(peer_, last.error());
    }
  } catch (const Malformed& fault) {
    throw PeerLost(peer_, fault.what());
  }
  throw PeerLost(peer_, error == asio::error::eof ? "closed the connection"
                                                  : "the connection broke (" + error.message() + ")");
}

// Runs in the heartbeat's thread and never waits: while a frame is being sent or the socket is full, the peer
// has bytes to read and needs no heartbeat. A heartbeat that the socket took only in part is completed before
// anything else is sent.
void Connection::beat() {
  const std::unique_lock lock(sending_, std::try_to_lock);
  if (!lock) return;
  // The owner of a connection that it looks at notices the end by itself, and at once.
  const bool closed = peer_closed();
  if (closed && was_closed_ && leave_) leave_();
  was_closed_ = closed;
  if (bytes_sent_ == bytes_sent_at_last_beat_) {
    if (rest_of_heartbeat_.empty()) rest_of_heartbeat_ = last_heartbeat_ = heartbeat_frame(progress_);
    try {
      error_code ignored;  // the owner meets it, too
      const std::size_t count = write_some(rest_of_heartbeat_, ignored);
      rest_of_heartbeat_ = rest_of_heartbeat_.subspan(count);
      bytes_sent_ += count;
    } catch (const std::exception&) {  // as above
    }
  }
  bytes_sent_at_last_beat_ = bytes_sent_;
}

bool Connection::peer_closed() {
  pollfd socket{socket_.native_handle(), POLLRDHUP, 0};
  return ::poll(&socket, 1, 0) == 1;
}

void Connection::close() {
  heartbeat_.reset();
  error_code error;
  if (tls_) tls_->shut_down();
  socket_.shutdown(Socket::shutdown_send, error);
  // Closing with unread bytes would reset the connection, and the last frame might be lost.
  std::array<std::byte, 4096> dropped;
  const auto deadline = Clock::now() + patience_.farewell;
  while (Clock::now() < deadline && (!error || error == asio::error::would_block)) {
    socket_.read_some(asio::buffer(dropped), error);
    if (error == asio::error::would_block) sleep(deadline, true, false);
  }
  const std::lock_guard lock(ending_);
  socket_.close(error);
}

void Connection::interrupt() {
  // The system call may be made from any thread, the functions of the socket object may not. The owner may be
  // closing it, and the next connection may get its number.
  const std::lock_guard lock(ending_);
  ::shutdown(socket_.native_handle(), SHUT_RDWR);
}

}  // namespace adit::protocol

#include "protocol/wire/connection.hpp"

#include <fmt/format.h>
#include <sched.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/error.hpp>
#include <thread>

#include "protocol/errors.hpp"
#include "protocol/wire/address.hpp"
#include "protocol/wire/error_frame.hpp"

namespace adit::protocol {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

// How an end waits for a frame:
// - A thread that sleeps on the socket wakes later than a whole round trip between two spinning ends takes,
// so
//   a wait begins by spinning for kSpin.
// - The end that asks also shortens its long waits. Answers take about as long as the last ones did, so it
//   sleeps by the clock for kNap of that time and then spins. The end that answers must not do so: its waits
//   contain the naps of the other end, and each would prolong the other's.
// - An answer that is later than expected is waited for asleep.
// - If other work needs the core, a yield lasts milliseconds. A yield longer than kSpin is the sign of that,
//   and the next kWaitsWithoutSpin waits sleep at once.
constexpr std::chrono::microseconds kSpin{200};
constexpr double kNap = 0.8;                               // share of the expected wait
constexpr std::chrono::milliseconds kLongestForecast{50};  // a late wake-up is negligible beside longer waits
constexpr int kWaitsWithoutSpin = 1000;
constexpr std::chrono::seconds kFarewell{2};  // time for the peer to read our last frame

std::string seconds(std::chrono::milliseconds time) {
  return fmt::format("{:g} s", std::chrono::duration<double>(time).count());
}

std::string describe(const asio::ip::tcp::socket& socket, std::string_view program) {
  error_code error;
  const auto end = socket.remote_endpoint(error);
  if (error) return std::string(program);
  return fmt::format("{} at {}", program, to_string(Address{end.address().to_string(), end.port()}));
}

}  // namespace

// The two deadlines of one wait: one for the silence of the peer, one for the wait as a whole.
class Connection::Watch {
 public:
  Watch(const Connection& connection, std::chrono::milliseconds within)
      : peer_(connection.peer_), silence_(connection.patience_.silence), within_(within) {}

  void sign_of_life(Clock::time_point now) { heard_ = now; }
  Clock::duration quiet_for(Clock::time_point now) const { return now - heard_; }
  Clock::duration lasted(Clock::time_point now) const { return now - start_; }
  Clock::time_point deadline() const { return std::min(heard_ + silence_, start_ + within_); }

  void check(Clock::time_point now) const {
    if (now - start_ >= within_) throw PeerLost(peer_, "no answer within " + seconds(within_));
    if (now - heard_ >= silence_) throw PeerLost(peer_, "no sign of life for " + seconds(silence_));
  }

 private:
  const std::string& peer_;
  std::chrono::milliseconds silence_;
  std::chrono::milliseconds within_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point heard_ = start_;
};

Connection::Connection(Socket&& socket, std::string_view program, const Patience& patience)
    : peer_(describe(socket, program)), patience_(patience) {
  const auto protocol = socket.local_endpoint().protocol();
  // The socket comes from the io_context of a listener or of connect(). Here it gets one of its own, which
  // only this object runs.
  socket_.assign(protocol, socket.release());
  // A frame is small and its answer is waited for; Nagle's algorithm would hold it back for more bytes.
  socket_.set_option(asio::ip::tcp::no_delay(true));
  socket_.non_blocking(true);
}

Traffic Connection::traffic() const {
  return {bytes_sent_, bytes_received_, std::chrono::duration<double>(waited_).count()};
}

void Connection::send(const wire::Frame& frame) {
  const std::lock_guard lock(sending_);
  const auto bytes = encoder_.encode(frame, send_limit_);
  write(rest_of_heartbeat_);
  rest_of_heartbeat_ = {};
  write(bytes);
}

void Connection::receive(wire::Frame& frame, std::chrono::milliseconds within) {
  await([&] { return take(frame); }, within);
  if (frame.has_error()) throw_error(peer_, frame.error());
}

void Connection::send_preamble() {
  const std::lock_guard lock(sending_);
  write(encode_preamble());
}

std::uint32_t Connection::receive_preamble() {
  std::optional<std::uint32_t> version;
  await([&] { return (version = decoder_.take_preamble()).has_value(); }, patience_.connect);
  return *version;
}

void Connection::establish(std::uint64_t peer_accepts_bytes) {
  decoder_.set_limit(kMaxFrameBytes);
  send_limit_ = std::min(peer_accepts_bytes, kMaxFrameBytes);
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
  if (expected > kSpin) std::this_thread::sleep_for(kNap * expected);
  const Clock::duration spin = may_spin ? expected + kSpin : Clock::duration::zero();
  while (true) {
    // The deadlines are checked after reading, so that bytes that have arrived in time count.
    const bool arrived = read_some();
    const auto now = Clock::now();
    if (arrived) watch.sign_of_life(now);
    if (arrived && take_complete()) {
      waited_ += watch.lasted(now);
      last_waits_[waits_++ % last_waits_.size()] = watch.lasted(now);
      return;
    }
    watch.check(now);
    if (watch.quiet_for(now) < spin) {
      sched_yield();
      if (Clock::now() - now > kSpin) waits_without_spin_ = kWaitsWithoutSpin;
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

bool Connection::take(wire::Frame& frame) {
  try {
    return decoder_.take(frame);
  } catch (const Malformed& error) {
    throw PeerLost(peer_, error.what());
  }
}

// Reads the bytes that have arrived; false if there are none.
bool Connection::read_some() {
  const auto space = decoder_.space();
  error_code error;
  const std::size_t count = socket_.read_some(asio::buffer(space.data(), space.size()), error);
  if (error == asio::error::would_block) return false;
  if (error) throw_closed(error);
  decoder_.arrived(count);
  bytes_received_ += count;
  return true;
}

// If the peer takes no bytes, this end keeps reading up to a limit. So it sees the peer's heartbeats, or the
// error for which the peer stopped reading.
void Connection::write(std::span<const std::byte> bytes) {
  std::optional<Watch> watch;
  while (!bytes.empty()) {
    error_code error;
    const std::size_t count = socket_.write_some(asio::buffer(bytes.data(), bytes.size()), error);
    if (!error) {
      bytes = bytes.subspan(count);
      bytes_sent_ += count;
      watch.reset();
      continue;
    }
    const bool may_read = decoder_.buffered() < kMaxHelloBytes;
    const bool heard = may_read && read_some();
    if (error != asio::error::would_block) throw_closed(error);
    if (!watch) watch.emplace(*this, patience_.answer);
    const auto now = Clock::now();
    if (heard) watch->sign_of_life(now);
    watch->check(now);
    sleep(watch->deadline(), may_read, true);
  }
}

// Sleeps until the socket is readable or writable, as asked, or until the given time.
void Connection::sleep(Clock::time_point until, bool readable, bool writable) {
  const auto wake = [](const error_code&) {};
  if (readable) socket_.async_wait(Socket::wait_read, wake);
  if (writable) socket_.async_wait(Socket::wait_write, wake);
  io_.restart();
  // A handler that still waits is cancelled and run, because the next call of sleep() adds its own.
  if (io_.run_one_until(until) == 1 && readable != writable) return;
  error_code ignored;
  socket_.cancel(ignored);
  io_.poll();
}

// Before it closed the connection, the peer may have sent an error that says why; that error is then thrown.
void Connection::throw_closed(const error_code& error) {
  wire::Frame last;
  while (take(last)) {
    if (last.has_error()) throw_error(peer_, last.error());
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
  if (bytes_sent_ == bytes_sent_at_last_beat_) {
    if (rest_of_heartbeat_.empty()) rest_of_heartbeat_ = heartbeat_frame();
    const auto count = ::send(socket_.native_handle(), rest_of_heartbeat_.data(), rest_of_heartbeat_.size(),
                              MSG_DONTWAIT | MSG_NOSIGNAL);
    if (count > 0) {
      rest_of_heartbeat_ = rest_of_heartbeat_.subspan(static_cast<std::size_t>(count));
      bytes_sent_ += static_cast<std::uint64_t>(count);
    } else if (rest_of_heartbeat_.size() == heartbeat_frame().size()) {
      rest_of_heartbeat_ = {};
    }
  }
  bytes_sent_at_last_beat_ = bytes_sent_;
}

void Connection::close() {
  heartbeat_.reset();
  error_code error;
  socket_.shutdown(Socket::shutdown_send, error);
  // As in refusal.cpp: closing with unread bytes would reset the connection, and the last frame might be
  // lost.
  std::array<std::byte, 4096> dropped;
  const auto deadline = Clock::now() + kFarewell;
  while (Clock::now() < deadline && (!error || error == asio::error::would_block)) {
    socket_.read_some(asio::buffer(dropped), error);
    if (error == asio::error::would_block) sleep(deadline, true, false);
  }
  socket_.close(error);
}

void Connection::interrupt() {
  // The system call may be made from any thread, the functions of the socket object may not.
  ::shutdown(socket_.native_handle(), SHUT_RDWR);
}

}  // namespace adit::protocol

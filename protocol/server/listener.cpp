#include "protocol/server/listener.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <boost/asio/ip/address.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <utility>

#include "protocol/errors.hpp"
#include "protocol/server/socket_file.hpp"
#include "protocol/wire/bounds.hpp"

namespace adit::protocol {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

constexpr std::chrono::milliseconds kAcceptAgain{100};  // pause after a failure such as too many open files

Endpoint endpoint_of(const Address& address) {
  error_code error;
  const Endpoints found = look_up(address, error);
  if (error) {
    throw UserError("", fmt::format("cannot listen on {}: the host is not known ({})", to_string(address),
                                    error.message()));
  }
  return found.front();
}

bool beyond_loopback(const Endpoint& endpoint) {
  const Address address = address_of(endpoint);
  return address.path.empty() && !asio::ip::make_address(address.host).is_loopback();
}

}  // namespace

Listener::Listener(const Address& address, bool anywhere, const std::vector<int>& stop_signals,
                   Greeting greeting, int adopt)
    : reception_(
          std::move(greeting), [this] { return busy(); },
          [this](std::shared_ptr<Connection> client) { return admit(std::move(client)); }) {
  const Endpoint endpoint = endpoint_of(address);
  if (beyond_loopback(endpoint) && !anywhere) {
    throw UserError(
        "", fmt::format("refusing to listen on {}: anyone on the way could read and change what is sent; "
                        "add --tls with a folder that adit certificates made, or listen on 127.0.0.1 and "
                        "connect through an ssh tunnel (ssh -L PORT:127.0.0.1:PORT HOST), or add --insecure "
                        "on a network that you trust",
                        to_string(address)));
  }
  error_code error;
  if (adopt < 0 && !address.path.empty()) make_room_for_socket(address.path);
  if (adopt >= 0)
    acceptor_.assign(endpoint.protocol(), adopt, error);
  else
    error = open(endpoint);
  if (error == asio::error::address_in_use && address.path.empty()) {
    throw UserError("", fmt::format("port {} on {} is in use: stop the program that listens there, or choose "
                                    "another port (0: any free one)",
                                    address.port, address.host));
  }
  if (error) {
    throw UserError("", fmt::format("cannot listen on {}: {}", to_string(address), error.message()));
  }
  file_ = address.path;
  sigset_t waiting;  // since exit_with() of server_main.cpp
  ::sigemptyset(&waiting);
  for (const int signal : stop_signals) {
    signals_.add(signal);
    ::sigaddset(&waiting, signal);
  }
  ::pthread_sigmask(SIG_UNBLOCK, &waiting, nullptr);
  signals_.async_wait([this](const error_code& cancelled, int) {
    if (!cancelled) stop();
  });
  accept();
  thread_ = std::thread([this] { io_.run(); });
}

error_code Listener::open(const Endpoint& endpoint) {
  error_code error;
  acceptor_.open(endpoint.protocol(), error);
  // The port of a server that has just ended can be used again at once, although its old connections linger.
  if (!error) acceptor_.set_option(asio::socket_base::reuse_address(true), error);
  if (!error) acceptor_.bind(endpoint, error);
  if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
  return error;
}

Listener::~Listener() {
  // Handlers that wait are dropped, because none may run once the members are destroyed.
  io_.stop();
  thread_.join();
  remove_socket(file_);
}

Address Listener::address() const {
  return address_of(acceptor_.local_endpoint());
}

std::shared_ptr<Connection> Listener::next_client() {
  std::unique_lock lock(mutex_);
  // A client may have connected since vacate(); it waits already, and the server stays busy with it.
  if (!waiting_) busy_ = false;
  changed_.wait(lock, [this] { return waiting_ || stop_.stop_requested(); });
  if (stop_.stop_requested()) return nullptr;
  return std::exchange(waiting_, nullptr);
}

void Listener::occupy(std::string with) {
  const std::lock_guard lock(mutex_);
  busy_with_ = std::move(with);
}

void Listener::vacate() {
  const std::lock_guard lock(mutex_);
  busy_ = false;
}

void Listener::accept() {
  acceptor_.async_accept([this](const error_code& error, Socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (!error) {
      reception_.receive(std::move(socket));
      return accept();
    }
    spdlog::warn("cannot accept a client: {}", error.message());
    // The failure would come back at once, and the log would fill.
    timer_.expires_after(kAcceptAgain);
    timer_.async_wait([this](const error_code& cancelled) {
      if (!cancelled) accept();
    });
  });
}

std::optional<std::string> Listener::busy() {
  const std::lock_guard lock(mutex_);
  return refusal();
}

std::optional<std::string> Listener::refusal() const {
  if (!busy_) return std::nullopt;
  return "busy with " + busy_with_;
}

std::optional<std::string> Listener::admit(std::shared_ptr<Connection> client) {
  const std::lock_guard lock(mutex_);
  if (auto why = refusal()) return why;
  busy_ = true;
  busy_with_ = "a client that has just connected";
  waiting_ = std::move(client);
  changed_.notify_one();
  return std::nullopt;
}

void Listener::stop() {
  acceptor_.cancel();
  {
    const std::lock_guard lock(mutex_);
    // Under the lock, so that the request cannot fall between the look and the wait of next_client(), which
    // would then sleep for ever.
    stop_.request_stop();
  }
  changed_.notify_one();
  timer_.expires_after(kLastOrders);
  // The process ends without destructors, because the thread that computes does not look at signals.
  timer_.async_wait([this](const error_code& cancelled) {
    if (cancelled) return;
    remove_socket(file_);
    std::_Exit(kSuccess);
  });
}

}  // namespace adit::protocol

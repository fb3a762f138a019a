#include "protocol/server/listener.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <utility>

#include "protocol/errors.hpp"
#include "protocol/server/refusal.hpp"

namespace adit::protocol {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

constexpr std::chrono::seconds kLastOrders{2};          // from a signal to the end of the process
constexpr std::chrono::milliseconds kAcceptAgain{100};  // pause after a failure such as too many open files

tcp::endpoint resolve(asio::io_context& io, const Address& address) {
  error_code error;
  const auto found = tcp::resolver(io).resolve(address.host, std::to_string(address.port), error);
  if (error) {
    throw UserError("", fmt::format("cannot listen on {}: the host is not known ({})", to_string(address),
                                    error.message()));
  }
  return found.begin()->endpoint();
}

}  // namespace

Listener::Listener(const Address& address, bool insecure) {
  const auto endpoint = resolve(io_, address);
  if (!endpoint.address().is_loopback() && !insecure) {
    throw UserError(
        "", fmt::format("refusing to listen on {}: servers do not authenticate their clients, so that "
                        "anyone who reaches this address could run models here; listen on 127.0.0.1 "
                        "and connect through an ssh tunnel (ssh -L PORT:127.0.0.1:PORT HOST), or "
                        "add --insecure on a network that you trust",
                        to_string(address)));
  }
  error_code error;
  acceptor_.open(endpoint.protocol(), error);
  // The port of a server that has just ended can be used again at once, although its old connections linger.
  if (!error) acceptor_.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor_.bind(endpoint, error);
  if (!error) acceptor_.listen(tcp::acceptor::max_listen_connections, error);
  if (error == asio::error::address_in_use) {
    throw UserError("", fmt::format("port {} on {} is in use: stop the program that listens there, or choose "
                                    "another port (0: any free one)",
                                    address.port, address.host));
  }
  if (error) {
    throw UserError("", fmt::format("cannot listen on {}: {}", to_string(address), error.message()));
  }
  signals_.add(SIGINT);
  signals_.add(SIGTERM);
  signals_.async_wait([this](const error_code& cancelled, int) {
    if (!cancelled) stop();
  });
  accept();
  thread_ = std::thread([this] { io_.run(); });
}

Listener::~Listener() {
  // Handlers that wait are dropped, because none may run once the members are destroyed.
  io_.stop();
  thread_.join();
}

Address Listener::address() const {
  const auto endpoint = acceptor_.local_endpoint();
  return {endpoint.address().to_string(), endpoint.port()};
}

std::optional<tcp::socket> Listener::next_client() {
  std::unique_lock lock(mutex_);
  // A client may have connected since vacate(); it waits already, and the server stays busy with it.
  if (!waiting_) busy_ = false;
  changed_.wait(lock, [this] { return waiting_ || stop_.stop_requested(); });
  if (stop_.stop_requested()) return std::nullopt;
  return std::exchange(waiting_, std::nullopt);
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
  acceptor_.async_accept([this](const error_code& error, tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (!error) {
      welcome(std::move(socket));
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

void Listener::welcome(tcp::socket socket) {
  const std::lock_guard lock(mutex_);
  if (busy_) return refuse(std::move(socket), "busy with " + busy_with_);
  busy_ = true;
  busy_with_ = "a client that has just connected";
  waiting_ = std::move(socket);
  changed_.notify_one();
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
  timer_.async_wait([](const error_code& cancelled) {
    if (!cancelled) std::_Exit(kSuccess);
  });
}

}  // namespace adit::protocol

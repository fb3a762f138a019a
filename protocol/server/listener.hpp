// Accepts the clients of a server in a thread of its own and hands out one at a time, greeted. Others are
// refused meanwhile and told why. Signals end the listener.
#pragma once

#include <boost/asio/basic_socket_acceptor.hpp>
#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "protocol/server/reception.hpp"
#include "protocol/wire/address.hpp"
#include "protocol/wire/connection.hpp"
#include "protocol/wire/resolve.hpp"

namespace adit::protocol {

class Listener {
 public:
  // Listens at `adopt`, a socket that listens already, unless that is -1. Throws UserError if the port or the
  // path is in use, the host is unknown, or the address lies beyond loopback and `anywhere` is not set. The
  // file of a Unix socket is removed at the end.
  Listener(const Address& address, bool anywhere, const std::vector<int>& stop_signals, Greeting greeting,
           int adopt = -1);
  ~Listener();
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  Address address() const;  // with the port in use, also where any free port was asked for
  int socket() { return acceptor_.native_handle(); }

  // Waits for the next client; null once the server is told to stop. Other clients are refused until vacate()
  // or the next call.
  std::shared_ptr<Connection> next_client();
  void occupy(std::string with);  // other clients are told "busy with ..."
  void vacate();                  // to be called before the last frame: the client may connect again at once

  // A signal asked the server to stop. A run that has not ended within kLastOrders ends with the process,
  // which loses nothing, because a server holds no results.
  std::stop_token stopping() const { return stop_.get_token(); }

 private:
  boost::system::error_code open(const Endpoint& endpoint);
  void accept();
  std::optional<std::string> busy();
  std::optional<std::string> refusal() const;  // with the lock
  std::optional<std::string> admit(std::shared_ptr<Connection> client);
  void stop();

  boost::asio::io_context io_{1};
  boost::asio::basic_socket_acceptor<boost::asio::generic::stream_protocol> acceptor_{io_};
  boost::asio::signal_set signals_{io_};
  boost::asio::steady_timer timer_{io_};

  std::filesystem::path file_;  // of a Unix socket

  std::mutex mutex_;
  std::condition_variable changed_;
  bool busy_ = false;
  std::string busy_with_;
  std::shared_ptr<Connection> waiting_;
  std::stop_source stop_;

  Reception reception_;  // its threads use what stands above
  std::thread thread_;
};

}  // namespace adit::protocol

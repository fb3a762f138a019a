// Accepts the clients of a server in a thread of its own and hands out one at a time. Clients that connect
// meanwhile are refused and told why. SIGINT and SIGTERM end the listener.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

#include "protocol/wire/address.hpp"

namespace adit::protocol {

class Listener {
 public:
  // Throws UserError if the port is in use, the host is unknown, or the address lies beyond loopback and
  // `insecure` is not set.
  Listener(const Address& address, bool insecure);
  ~Listener();
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  Address address() const;  // with the port in use, also where any free port was asked for

  // Waits for the next client; nothing once the server is told to stop. Other clients are refused until
  // vacate() or the next call.
  std::optional<boost::asio::ip::tcp::socket> next_client();
  void occupy(std::string with);  // other clients are told "busy with ..."
  void vacate();                  // to be called before the last frame: the client may connect again at once

  // A signal asked the server to stop. A run that has not ended within kLastOrders ends with the process,
  // which loses nothing, because a server holds no results.
  std::stop_token stopping() const { return stop_.get_token(); }

 private:
  void accept();
  void welcome(boost::asio::ip::tcp::socket socket);
  void stop();

  boost::asio::io_context io_{1};
  boost::asio::ip::tcp::acceptor acceptor_{io_};
  boost::asio::signal_set signals_{io_};
  boost::asio::steady_timer timer_{io_};

  std::mutex mutex_;
  std::condition_variable changed_;
  bool busy_ = false;
  std::string busy_with_;
  std::optional<boost::asio::ip::tcp::socket> waiting_;
  std::stop_source stop_;

  std::thread thread_;
};

}  // namespace adit::protocol

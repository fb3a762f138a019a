// Where a server's clients arrive: accepts them in a thread of its own, hands out one at a time, and tells
// those who come meanwhile why they are refused. SIGINT and SIGTERM end it.
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
  // A port in use, an unknown host, and an address beyond loopback unless `insecure`, are UserErrors.
  Listener(const Address& address, bool insecure);
  ~Listener();
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  Address address() const;  // with the port that was found

  // Waits for the next client; none: told to stop. Until vacate(), or the next call, others are refused.
  std::optional<boost::asio::ip::tcp::socket> next_client();
  void occupy(std::string with);  // what others are told: "busy with ..."
  void vacate();                  // before the last frame: the client may come back at once

  // Asked to stop by a signal. Who then has not ended within kLastOrders is ended with the process, which
  // loses nothing: a server holds no results.
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

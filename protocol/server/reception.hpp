// Greets the clients of a server, each in a thread of its own. One that stays silent or does not know the
// server's secret keeps nobody else away.
#pragma once

#include <atomic>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "protocol/wire/connection.hpp"

namespace adit::protocol {

// What a server says of itself, and asks of its clients.
struct Greeting {
  std::string program;
  std::string secret;      // empty: any client is admitted
  std::optional<Tls> tls;  // none: clients come without TLS
  Patience patience;
  std::vector<std::string> computes;  // see Hello in wire.proto
};

class Reception {
 public:
  // Called from a client's thread, once the client is greeted. Returns why it is refused, or nothing where it
  // is taken.
  using Admit = std::function<std::optional<std::string>(std::shared_ptr<Connection>)>;

  // Why any client would be refused now, or nothing. Who needs no proof is told in the place of hello.
  using Busy = std::function<std::optional<std::string>()>;

  Reception(Greeting greeting, Busy busy, Admit admit);
  ~Reception();
  Reception(const Reception&) = delete;
  Reception& operator=(const Reception&) = delete;

  // Returns at once. Of too many clients that are not greeted yet, the one that has waited longest is sent
  // away. Called from one thread.
  void receive(Socket socket);

 private:
  struct Guest {
    std::shared_ptr<Connection> connection;
    bool admitted = false;
    std::atomic<bool> gone = false;
    std::thread thread;
  };
  void greet(Guest& guest);
  std::optional<std::string> admit(Guest& guest);
  void dismiss(Guest& guest);

  Greeting greeting_;
  Busy busy_;
  Admit admit_;
  std::mutex admitting_;
  std::list<Guest> guests_;
};

}  // namespace adit::protocol

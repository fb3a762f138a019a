// Starts the servers that a scene needs.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "protocol/wire/address.hpp"
#include "protocol/wire/connection.hpp"

namespace adit::coupler {

// A server process that lives as long as this object. If the coupler is killed, the kernel stops the server.
class ServerProcess {
 public:
  // Starts the executable `program` of the same installation or build tree and waits until it listens. Its
  // log is written anew to `log`, which must not be a link; an empty path keeps it nowhere. Only this process
  // can use the server, by a secret of its own. With `by_unix_socket` it listens at a Unix socket in a folder
  // of this user alone; else, or where none can be made, on loopback at a free port. Throws
  // protocol::PeerLost, with how the server ended and the last line of its log, if it does not start.
  ServerProcess(const std::string& program, const std::filesystem::path& log, bool by_unix_socket,
                std::vector<std::string> options = {});
  ~ServerProcess();
  ServerProcess(const ServerProcess&) = delete;
  ServerProcess& operator=(const ServerProcess&) = delete;

  // To be called once: the socket and its folder are then taken from the file system, so that nothing is left
  // there if both processes are killed.
  std::unique_ptr<protocol::Connection> connect();
  const std::string& secret() const { return secret_; }

 private:
  struct Child;
  std::string program_;
  std::unique_ptr<Child> child_;
  protocol::Address address_;
  std::string secret_;
};

}  // namespace adit::coupler

// Starts the servers that a scene needs, on loopback and on free ports.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "protocol/wire/address.hpp"

namespace adit::coupler {

// A server process that lives as long as this object. If the coupler is killed, the kernel stops the server.
class ServerProcess {
 public:
  // Starts the executable `program` of the same installation or build tree and waits until it listens. Its
  // log is written to `log`. Throws protocol::PeerLost if the server does not start.
  ServerProcess(const std::string& program, const std::filesystem::path& log,
                std::vector<std::string> options = {});
  ~ServerProcess();
  ServerProcess(const ServerProcess&) = delete;
  ServerProcess& operator=(const ServerProcess&) = delete;

  const protocol::Address& address() const { return address_; }

 private:
  struct Child;
  std::unique_ptr<Child> child_;
  protocol::Address address_;
};

}  // namespace adit::coupler

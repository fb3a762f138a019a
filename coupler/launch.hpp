// Starting the servers that a scene needs, on loopback and free ports.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "protocol/wire/address.hpp"

namespace adit::coupler {

// A server process that lives as long as this object: stopped at the end, and by the kernel should the
// coupler itself be killed.
class ServerProcess {
 public:
  // Starts the executable `program` that lies beside the coupler's folder in the build tree, and waits until
  // it listens. Its log goes to `log`. A server that does not come up is a protocol::PeerLost.
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

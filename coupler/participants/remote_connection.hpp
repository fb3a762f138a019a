// A participant at the other end of a connection.
#pragma once

#include <memory>
#include <string>

#include "coupler/participants/connection.hpp"
#include "protocol/wire/connection.hpp"

namespace adit::coupler {

class RemoteConnection : public Connection {
 public:
  explicit RemoteConnection(std::unique_ptr<protocol::Connection> connection)
      : connection_(std::move(connection)) {}

  const std::string& name() const override { return connection_->peer(); }
  void post(const wire::Frame& request) override { connection_->send(request); }
  void collect(wire::Frame& reply) override { connection_->receive(reply); }

 private:
  std::unique_ptr<protocol::Connection> connection_;
};

}  // namespace adit::coupler

// A participant at the other end of a connection.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "coupler/participants/connection.hpp"
#include "coupler/servers/answer_bounds.hpp"
#include "protocol/errors.hpp"
#include "protocol/wire/connection.hpp"

namespace adit::coupler {

// Each answer has a longest wait and a greatest length, by what was asked: a model may take hours and
// gigabytes, a step neither.
class RemoteConnection : public Connection {
 public:
  explicit RemoteConnection(std::unique_ptr<protocol::Connection> connection)
      : connection_(std::move(connection)) {}

  const std::string& name() const override { return connection_->peer(); }
  void post(const wire::Frame& request) override;
  void collect(wire::Frame& reply) override;
  std::string progress() const override { return connection_->progress_of_peer(); }

 private:
  std::unique_ptr<protocol::Connection> connection_;
  std::chrono::milliseconds wait_{};  // for the answer to the request posted last
  AnswerBounds bounds_;
};

}  // namespace adit::coupler

// A participant at the other end of a connection.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "coupler/participants/participant.hpp"
#include "protocol/errors.hpp"
#include "protocol/messages/wire.pb.h"
#include "protocol/wire/connection.hpp"

namespace adit::coupler {

// The longest answer to each kind of request, by what the participant told of its model before. Nothing
// longer is received.
class AnswerBounds {
 public:
  // What is asked, and what is answered, in turn.
  void asked(const wire::Frame& request);
  void answered(const wire::Frame& answer);

  // Of the answer to the request of this kind asked last [bytes], all of its parts together.
  std::uint64_t longest(wire::Frame::ContentCase request) const;

 private:
  std::uint64_t samples_ = 0;           // points of the model
  std::uint64_t bonds_ = 0;             // that may break in a step
  std::uint64_t coupling_numbers_ = 0;  // that state its coupling points
  std::uint64_t masters_ = 0;           // to which it is condensed
};

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

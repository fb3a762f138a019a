#pragma once

#include <string>

#include "protocol/messages/wire.pb.h"

namespace adit::coupler {

// The way to a participant: a server at the other end of a connection, or an object in the same process.
class Connection {
 public:
  virtual ~Connection() = default;
  virtual const std::string& name() const = 0;
  virtual void post(const wire::Frame& request) = 0;  // does not wait for the answer
  virtual void collect(wire::Frame& reply) = 0;       // the answer to the request posted last
  // How far the participant is meanwhile, where it says so; from any thread.
  virtual std::string progress() const { return {}; }
};

}  // namespace adit::coupler

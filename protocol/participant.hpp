// What a solver fills in to take part in a run. The server calls these in the order of the conversation
// (wire.proto), one participant object a run; each function reads the request and fills the answer, whose
// memory is reused from step to step. Errors are thrown as UserError (the scene) or Unstable.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "protocol/wire.pb.h"

namespace adit::protocol {

class Participant {
 public:
  virtual ~Participant() = default;
  virtual void set_up(const wire::Setup& setup, wire::Model& model) = 0;
  virtual void weigh(const wire::Weights& weights, wire::Interface& interface) = 0;
  virtual void couple(const wire::Couple& couple, wire::Operator& op) = 0;
  virtual void advance(const wire::Advance& advance, wire::Predicted& predicted) = 0;
  virtual void snapshot(wire::Snapshot& snapshot) = 0;
  virtual void finish(wire::Bye& bye) = 0;
};

using ParticipantFactory = std::function<std::unique_ptr<Participant>()>;

// Lets the participant answer one request (setup … finish). A request out of order, or one that no
// participant answers, throws std::logic_error. The clock of `predicted.compute_seconds` runs here.
void answer(Participant& participant, const wire::Frame& request, wire::Frame& reply);

}  // namespace adit::protocol

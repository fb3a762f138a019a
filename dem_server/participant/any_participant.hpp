// The participant that a scene's particles need: a lattice of equal, contact-bonded discs is computed by
// DemParticipant, faster; all else by DiscsParticipant.
#pragma once

#include <memory>

#include "protocol/participant/participant.hpp"

namespace adit::dem {

class AnyParticipant : public protocol::Participant {
 public:
  // Threads that share the computing, 0: as many as pay. Results do not depend on their number.
  explicit AnyParticipant(std::size_t threads = 1) : threads_(threads) {}

  void set_up(const wire::Setup& setup, wire::Model& model) override;
  void weigh(const wire::Weights& weights, wire::Interface& interface) override {
    own_->weigh(weights, interface);
  }
  void couple(const wire::Couple& couple, wire::Operator& op) override { own_->couple(couple, op); }
  void advance(const wire::Advance& advance, wire::Predicted& predicted) override {
    own_->advance(advance, predicted);
  }
  void complete() override { own_->complete(); }
  void snapshot(const wire::SnapshotRequest& request, wire::Snapshot& snapshot) override {
    own_->snapshot(request, snapshot);
  }
  void finish(wire::Bye& bye) override { own_->finish(bye); }

 private:
  std::size_t threads_;
  std::unique_ptr<protocol::Participant> own_;
};

}  // namespace adit::dem

// What takes part in a run. The server calls these in the order of the conversation (wire.proto), one
// participant object a run; each function reads the request and fills the answer, which arrives cleared but
// keeps its memory from step to step. Errors are thrown as UserError (the scene), RequestError (the other
// end) or Unstable. Solvers derive from SteppedParticipant, which knows how the requests of a step are
// answered.
//
// The answer to advance needs the velocities at the coupling points only. What else belongs to the step may
// be left to complete(), which is called once that answer was sent: others then need not wait for it. Results
// are the same to the last bit wherever it is done.
#pragma once

#include <cstdint>
#include <ctime>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "protocol/log/progress.hpp"
#include "protocol/messages/wire.pb.h"
#include "protocol/participant/state_transfer.hpp"

namespace adit::protocol {

class Participant {
 public:
  virtual ~Participant() = default;
  // Who hears how far a long set-up is.
  void report_to(Progress progress) { progress_ = std::move(progress); }
  virtual void set_up(const wire::Setup& setup, wire::Model& model) = 0;
  virtual void weigh(const wire::Weights& weights, wire::Interface& interface) = 0;
  virtual void couple(const wire::Couple& couple, wire::Operator& op) = 0;
  // Says why it cannot wait, unless it can.
  virtual void condense(const wire::Condense& /*condense*/, wire::Condensed& condensed) {
    condensed.set_reason("this model cannot wait");
  }
  virtual void advance(const wire::Advance& advance, wire::Predicted& predicted) = 0;
  // The rest of the step answered last, before any other request. It reports in the next answer.
  virtual void complete() {}
  // The time that the last step took, complete() included [s].
  virtual void took(double /*seconds*/) {}
  virtual void snapshot(const wire::SnapshotRequest& request, wire::Snapshot& snapshot) = 0;
  // Names the states that exchange() writes and reads, as in "dem_server 1.2.0"; empty: there are none.
  virtual std::string state_format() const { return {}; }
  // What changes from step to step: of a participant that was set up alike, coupled, and made no step where
  // it reads.
  virtual void exchange(state::Archive& /*archive*/) {}
  virtual void finish(wire::Bye& bye) = 0;

 protected:
  const Progress& progress() const { return progress_; }

 private:
  Progress progress_ = [](const std::string&) {};
};

using ParticipantFactory = std::function<std::unique_ptr<Participant>()>;

// One run as seen by a participant: hands it the requests, and only in their order:
//
//   setup, weights, [couple], [condense], then any number of advance (steps 0, 1, 2 ...) and snapshot; where
//   the first steps relax, they are numbered from 0, and those that follow from 0 again restore, in parts,
//   before the first step; save, in parts, after any finish at any time after setup
class Conversation {
 public:
  explicit Conversation(Participant& participant) : participant_(participant) {}

  // Answers one request. The scene of `setup` is checked against its rules first. The clocks of
  // `predicted.compute_seconds` and `bye.cpu_seconds` run here. A request out of order, or one that no
  // participant answers, throws RequestError.
  void answer(const wire::Frame& request, wire::Frame& reply);

  // To be called when the answer was sent: completes the step that it answered, where something is left of
  // it. Does not throw: an error here is that of the next answer.
  void complete();

  bool finished() const { return stage_ == Stage::kFinished; }

  bool began() const { return stage_ != Stage::kConnected; }

  // Models are still being built, this one or others, which may take hours.
  bool builds() const { return stage_ < Stage::kRunning; }

  // The longest message [bytes] that the next request may be: what its kind, and the sizes told so far,
  // allow.
  std::uint64_t longest_request() const;

 private:
  enum class Stage { kConnected, kSetUp, kWeighed, kRunning, kFinished };

  void require(bool in_order, const wire::Frame& request) const;
  bool in_order(const wire::Advance& request) const;
  void save(const wire::Save& request, wire::State& state);
  void restore(const wire::Restore& request);
  void exchange(state::Archive& archive);
  void advance(const wire::Advance& request, wire::Predicted& predicted);

  Participant& participant_;
  Stage stage_ = Stage::kConnected;
  std::uint64_t samples_ = 0;  // points of the model
  std::uint64_t numbers_ = 0;  // that a request may bring: weights, then impulses
  std::uint64_t next_step_ = 0;
  bool relaxing_ = false;       // the last step did
  bool step_open_ = false;      // answered, but not completed
  std::clock_t cpu_start_ = 0;  // at set-up
  double compute_seconds_ = 0;  // before the last step was answered
  double hidden_seconds_ = 0;   // in complete() since then
  std::exception_ptr failure_;  // of complete()
  StateParts parts_;            // of the state that is being saved or restored
};

}  // namespace adit::protocol

#include "protocol/participant/participant.hpp"

#include <fmt/format.h>

#include <chrono>

#include "protocol/errors.hpp"
#include "protocol/memory.hpp"
#include "protocol/scene/fields/check_rules.hpp"

namespace adit::protocol {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string name_of(const wire::Frame& frame) {
  const auto* field = wire::Frame::descriptor()->FindFieldByNumber(frame.content_case());
  return field != nullptr ? field->name() : "nothing";
}

// The answer's place in the reply, emptied; its memory stays when the last answer was of the same kind.
template <class Message>
Message& cleared(Message* message) {
  message->Clear();
  return *message;
}

}  // namespace

void Conversation::answer(const wire::Frame& request, wire::Frame& reply) {
  complete();
  if (failure_) std::rethrow_exception(failure_);
  const bool ready = stage_ == Stage::kWeighed || stage_ == Stage::kRunning;
  switch (request.content_case()) {
    case wire::Frame::kSetup:
      require(stage_ == Stage::kConnected, request);
      cpu_start_ = std::clock();
      check_rules(request.setup().scene());
      participant_.set_up(request.setup(), cleared(reply.mutable_model()));
      stage_ = Stage::kSetUp;
      break;
    case wire::Frame::kWeights:
      require(stage_ == Stage::kSetUp, request);
      participant_.weigh(request.weights(), cleared(reply.mutable_interface()));
      reply.mutable_interface()->set_resident_bytes(resident_bytes());
      stage_ = Stage::kWeighed;
      break;
    case wire::Frame::kCouple:
      require(stage_ == Stage::kWeighed, request);
      participant_.couple(request.couple(), cleared(reply.mutable_operator_()));
      stage_ = Stage::kRunning;
      break;
    case wire::Frame::kAdvance:
      require(ready && in_order(request.advance()), request);
      advance(request.advance(), cleared(reply.mutable_predicted()));
      stage_ = Stage::kRunning;
      break;
    case wire::Frame::kSnapshotRequest:
      require(ready, request);
      participant_.snapshot(request.snapshot_request(), cleared(reply.mutable_snapshot()));
      break;
    case wire::Frame::kFinish:
      require(stage_ == Stage::kSetUp || ready, request);
      participant_.finish(cleared(reply.mutable_bye()));
      reply.mutable_bye()->set_cpu_seconds(static_cast<double>(std::clock() - cpu_start_) / CLOCKS_PER_SEC);
      stage_ = Stage::kFinished;
      break;
    default:
      require(false, request);
  }
}

bool Conversation::in_order(const wire::Advance& request) const {
  if (!request.relax()) return request.step() == (relaxing_ ? 0 : next_step_);
  return request.step() == next_step_ && (relaxing_ || next_step_ == 0);
}

void Conversation::advance(const wire::Advance& request, wire::Predicted& predicted) {
  const auto start = Clock::now();
  participant_.advance(request, predicted);
  predicted.set_compute_seconds(seconds_since(start));
  predicted.set_hidden_seconds(hidden_seconds_);
  hidden_seconds_ = 0;
  next_step_ = request.step() + 1;
  relaxing_ = request.relax();
  step_open_ = true;
}

void Conversation::complete() {
  if (!step_open_) return;
  step_open_ = false;
  const auto start = Clock::now();
  try {
    participant_.complete();
  } catch (...) {
    failure_ = std::current_exception();
  }
  hidden_seconds_ = seconds_since(start);
}

void Conversation::require(bool in_order, const wire::Frame& request) const {
  if (in_order) return;
  constexpr const char* kExpected[] = {"setup", "weights or finish",
                                       "couple, advance, snapshot_request or finish",
                                       "advance, snapshot_request or finish", "nothing more"};
  throw RequestError(
      fmt::format("request out of order: {}{}, where {} was expected (next step: {})", name_of(request),
                  request.has_advance() ? fmt::format(" to step {}", request.advance().step()) : "",
                  kExpected[static_cast<int>(stage_)], next_step_));
}

}  // namespace adit::protocol

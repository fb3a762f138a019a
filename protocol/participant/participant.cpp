#include "protocol/participant/participant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "protocol/errors.hpp"
#include "protocol/machine/memory.hpp"
#include "protocol/scene/fields/check_rules.hpp"
#include "protocol/wire/bounds.hpp"
#include "protocol/wire/content/finite.hpp"

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

// Participants look at their own velocities; energies are sums over all that they hold.
void require_finite_energies(const wire::Frame& reply) {
  if (!reply.predicted().has_energies()) return;
  if (const auto wrong = first_not_finite(reply))
    throw Unstable(
        fmt::format("step {}: {}; choose a smaller time.dt_factor", reply.predicted().step(), *wrong));
}

}  // namespace

void Conversation::answer(const wire::Frame& request, wire::Frame& reply) {
  complete();
  if (failure_) std::rethrow_exception(failure_);
  if (const auto wrong = first_not_finite(request)) throw RequestError("a number must be finite: " + *wrong);
  const bool ready = stage_ == Stage::kWeighed || stage_ == Stage::kRunning;
  switch (request.content_case()) {
    case wire::Frame::kSetup:
      require(stage_ == Stage::kConnected, request);
      cpu_start_ = std::clock();
      check_rules(request.setup().scene());
      participant_.set_up(request.setup(), cleared(reply.mutable_model()));
      reply.mutable_model()->set_state_format(participant_.state_format());
      samples_ = static_cast<std::uint64_t>(reply.model().sample_points_size()) / 2;
      numbers_ = samples_;
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
      numbers_ = static_cast<std::uint64_t>(request.couple().points_size());
      stage_ = Stage::kRunning;
      break;
    case wire::Frame::kCondense:
      require(stage_ == Stage::kRunning, request);
      participant_.condense(request.condense(), cleared(reply.mutable_condensed()));
      break;
    case wire::Frame::kAdvance:
      require(ready && in_order(request.advance()), request);
      advance(request.advance(), cleared(reply.mutable_predicted()));
      require_finite_energies(reply);
      stage_ = Stage::kRunning;
      break;
    case wire::Frame::kSnapshotRequest:
      require(ready, request);
      participant_.snapshot(request.snapshot_request(), cleared(reply.mutable_snapshot()));
      break;
    case wire::Frame::kSave:
      require(ready && !participant_.state_format().empty(), request);
      save(request.save(), cleared(reply.mutable_state()));
      break;
    case wire::Frame::kRestore:
      require(ready && next_step_ == 0 && !participant_.state_format().empty(), request);
      reply.mutable_restored();
      restore(request.restore());
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

std::uint64_t Conversation::longest_request() const {
  if (stage_ == Stage::kConnected) return kMaxSetupBytes;
  return std::max(kMaxRunBytes, numbers_ * sizeof(double) + kMaxHelloBytes);
}

bool Conversation::in_order(const wire::Advance& request) const {
  if (request.has_follow()) return request.step() >= (relaxing_ ? 0 : next_step_);
  if (!request.relax()) return request.step() == (relaxing_ ? 0 : next_step_);
  return request.step() == next_step_ && (relaxing_ || next_step_ == 0);
}

void Conversation::advance(const wire::Advance& request, wire::Predicted& predicted) {
  const auto start = Clock::now();
  participant_.advance(request, predicted);
  compute_seconds_ = seconds_since(start);
  predicted.set_compute_seconds(compute_seconds_);
  predicted.set_hidden_seconds(hidden_seconds_);
  hidden_seconds_ = 0;
  next_step_ = request.step() + 1;
  relaxing_ = request.relax();
  step_open_ = true;
}

void Conversation::save(const wire::Save& request, wire::State& state) {
  if (request.offset() == 0) {
    state::Archive archive;
    exchange(archive);
    parts_.hold(archive.take());
  }
  parts_.give(request.offset(), state);
}

void Conversation::restore(const wire::Restore& request) {
  if (!parts_.receive(request, most_state_bytes(samples_))) return;
  state::Archive archive(parts_.take());
  exchange(archive);
  archive.require_end();
  stage_ = Stage::kRunning;
}

void Conversation::exchange(state::Archive& archive) {
  archive("next_step", next_step_);
  archive("relaxing", relaxing_);
  participant_.exchange(archive);
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
  participant_.took(compute_seconds_ + hidden_seconds_);
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

#include "coupler/stepper.hpp"

#include <algorithm>
#include <chrono>

#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void fill(google::protobuf::RepeatedField<double>& field, const std::vector<double>& values) {
  field.Resize(static_cast<int>(values.size()), 0.0);
  std::copy(values.begin(), values.end(), field.mutable_data());
}

void require(const Side& side, const char* what, int found, std::size_t expected) {
  if (static_cast<std::size_t>(found) != expected)
    throw protocol::PeerLost(side.peer->name(), "predicted " + std::to_string(found) + " " + what +
                                                    " where " + std::to_string(expected) + " were expected");
}

void receive_prediction(Side& side) {
  collect(side, wire::Frame::kPredicted);
  const wire::Predicted& predicted = side.prediction();
  side.compute_s += predicted.compute_seconds();
  side.hidden_s += predicted.hidden_seconds();
  const wire::Advance& asked = side.request.advance();
  if (predicted.step() != asked.step() || predicted.has_energies() != asked.want_energies())
    throw protocol::PeerLost(side.peer->name(), "predicted something else than step " +
                                                    std::to_string(asked.step()) +
                                                    ", or not the energies that were asked for");
  if (predicted.has_relaxation() != asked.relax())
    throw protocol::PeerLost(side.peer->name(), asked.relax()
                                                    ? "does not know statics: its answer has no relaxation"
                                                    : "relaxes, which it was not asked for");
  require(side, "velocities", predicted.velocities_size(), side.predicted.size());
  require(side, "histories", predicted.histories_size(), asked.want_histories() ? side.histories : 0);
  const bool whole_step = asked.want_histories() || asked.want_energies();
  if (side.member.role == Role::kParticles && whole_step &&
      (predicted.strongest().empty() || predicted.strongest().rbegin()->step() != asked.step()))
    throw protocol::PeerLost(side.peer->name(),
                             "did not say the largest bond force of step " + std::to_string(asked.step()));
  std::copy(predicted.velocities().begin(), predicted.velocities().end(), side.predicted.begin());
}

// corrected = predicted + N M⁻¹ Nᵀ impulses: what the participant will apply, at the coupling points.
void correct_velocities(Side& side) {
  const Interpolation& n = *side.interpolation;
  n.gather(side.impulses, side.own);
  n.divide_by_mass(side.own);
  n.interpolate(side.own, side.corrected);
  for (std::size_t i = 0; i < side.corrected.size(); ++i) side.corrected[i] += side.predicted[i];
}

// Participants that compute longer are asked first and heard last, so that the exchange with the others is
// hidden.
void sort_slowest_first(std::vector<Side*>& sides) {
  std::stable_sort(sides.begin(), sides.end(),
                   [](const Side* a, const Side* b) { return a->compute_s > b->compute_s; });
}

}  // namespace

Stepper::Stepper(Model& model) : model_(model), ledger_(model.sides, model.interfaces) {
  for (Side& side : model.sides) order_.push_back(&side);
}

void Stepper::step(std::uint64_t n, Wanted wanted) {
  if (n == 0) impulses_pending_ = false;  // what statics left has no meaning from rest
  request_.Clear();
  request_.set_step(n);
  request_.set_dt(model_.dt);
  request_.set_want_energies(wanted.energies);
  request_.set_want_histories(wanted.histories);
  exchange();
  unbooked_step_ = n;
  if (wanted.energies) book(true);
}

void Stepper::relax(std::uint64_t n, bool stop) {
  request_.Clear();
  request_.set_step(n);
  request_.set_dt(model_.dt);
  request_.set_relax(true);
  request_.set_stop(stop);
  exchange();
}

// One round trip to all sides, and the multipliers that correct what they predicted.
void Stepper::exchange() {
  const auto start = Clock::now();
  sort_slowest_first(order_);
  for (Side* side : order_) post_advance(*side);
  impulses_pending_ = false;
  book(false);  // the step before, while the participants compute this one
  for (auto side = order_.rbegin(); side != order_.rend(); ++side) receive_prediction(**side);
  wait_s_ += seconds_since(start);

  const auto answered = Clock::now();
  if (model_.constraint) {
    model_.constraint->solve(model_.sides);
    impulses_pending_ = true;
  }
  solve_s_ += seconds_since(answered);
}

void Stepper::book(bool with_energies) {
  if (!unbooked_step_) return;
  if (model_.constraint)
    for (Side& side : model_.sides) correct_velocities(side);
  ledger_.add_step(*unbooked_step_, model_.sides, with_energies);
  unbooked_step_.reset();
}

void Stepper::post_advance(Side& side) {
  wire::Advance& advance = *side.request.mutable_advance();
  advance.CopyFrom(request_);
  if (impulses_pending_) fill(*advance.mutable_impulses(), side.impulses);
  side.peer->post(side.request);
}

std::vector<wire::Snapshot> Stepper::snapshots() {
  for (Side& side : model_.sides) {
    auto& request = *side.request.mutable_snapshot_request();
    if (impulses_pending_) fill(*request.mutable_impulses(), side.impulses);
    side.peer->post(side.request);
  }
  impulses_pending_ = false;
  std::vector<wire::Snapshot> snapshots;
  for (Side& side : model_.sides) {
    collect(side, wire::Frame::kSnapshot);
    snapshots.push_back(std::move(*side.reply.mutable_snapshot()));
  }
  return snapshots;
}

}  // namespace adit::coupler

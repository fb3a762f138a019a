#include "coupler/stepper.hpp"

#include <algorithm>
#include <array>
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
  const wire::Advance& asked = side.request.advance();
  if (predicted.step() != asked.step() || predicted.has_energies() != asked.want_energies())
    throw protocol::PeerLost(side.peer->name(), "predicted something else than step " +
                                                    std::to_string(asked.step()) +
                                                    ", or not the energies that were asked for");
  require(side, "velocities", predicted.velocities_size(), side.predicted.size());
  require(side, "histories", predicted.histories_size(), asked.want_histories() ? side.histories : 0);
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

// The slower participant is asked first and heard last, so that the exchange with the other is hidden. At
// most two take part; absent ones are null.
std::array<Side*, 2> slower_first(std::vector<Side>& sides) {
  if (sides.size() == 1) return {&sides[0], nullptr};
  if (sides[0].compute_s > sides[1].compute_s) return {&sides[0], &sides[1]};
  return {&sides[1], &sides[0]};
}

}  // namespace

Stepper::Stepper(Model& model)
    : model_(model),
      ledger_(model.sides.size(), model.coupling_points.size()),
      gap_(model.coupling_points.size()),
      multipliers_(model.coupling_points.size()) {}

void Stepper::step(std::uint64_t n, Wanted wanted) {
  const auto start = Clock::now();
  const std::array<Side*, 2> order = slower_first(model_.sides);
  for (Side* side : order)
    if (side) post_advance(*side, n, wanted);
  impulses_pending_ = false;
  book(false);  // the step before, while the participants compute this one
  for (auto side = order.rbegin(); side != order.rend(); ++side)
    if (*side) receive_prediction(**side);
  wait_s_ += seconds_since(start);

  const auto answered = Clock::now();
  if (model_.overlap) solve();
  unbooked_step_ = n;
  if (wanted.energies) book(true);
  solve_s_ += seconds_since(answered);
}

void Stepper::book(bool with_energies) {
  if (!unbooked_step_) return;
  if (model_.overlap)
    for (Side& side : model_.sides) correct_velocities(side);
  ledger_.add_step(*unbooked_step_, model_.sides, with_energies);
  unbooked_step_.reset();
}

void Stepper::post_advance(Side& side, std::uint64_t n, Wanted wanted) {
  wire::Advance& advance = *side.request.mutable_advance();
  advance.set_step(n);
  advance.set_dt(model_.dt);
  advance.set_want_energies(wanted.energies);
  advance.set_want_histories(wanted.histories);
  if (impulses_pending_)
    fill(*advance.mutable_impulses(), side.impulses);
  else
    advance.clear_impulses();
  side.peer->post(side.request);
}

void Stepper::solve() {
  Side& continuum = model_.sides[0];
  Side& particles = model_.sides[1];
  for (std::size_t i = 0; i < gap_.size(); ++i) gap_[i] = continuum.predicted[i] - particles.predicted[i];
  model_.solve->solve(gap_, multipliers_);
  for (std::size_t i = 0; i < gap_.size(); ++i) {
    continuum.impulses[i] = -multipliers_[i];
    particles.impulses[i] = multipliers_[i];
  }
  impulses_pending_ = true;
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

#include "coupler/exchange/round_trip.hpp"

#include <algorithm>
#include <set>
#include <string>

#include "coupler/exchange/as_asked.hpp"

namespace adit::coupler {
namespace {

// Participants that compute longer are asked first and heard last, so that the exchange with the others is
// hidden.
void sort_slowest_first(std::vector<Participant*>& participants) {
  std::stable_sort(participants.begin(), participants.end(),
                   [](const Participant* a, const Participant* b) { return a->compute_s > b->compute_s; });
}

}  // namespace

void fill_request(wire::Advance& request, std::uint64_t step, double dt, Wanted wanted) {
  request.Clear();
  request.set_step(step);
  request.set_dt(dt);
  request.set_want_energies(wanted.energies);
  request.set_want_histories(wanted.histories);
  request.set_want_peaks(wanted.peaks);
}

void post_advance(Participant& participant, const wire::Advance& request) {
  wire::Advance& advance = *participant.request.mutable_advance();
  // The message of the last step is overwritten, so that its arrays keep their memory.
  advance.CopyFrom(request);
  advance.set_dt(request.dt() * participant.step_ratio);
  advance.set_scale_masses(participant.scaled_masses);
  if (participant.drift) {
    advance.set_drift_x(participant.drift->x);
    advance.set_drift_y(participant.drift->y);
    participant.drift.reset();
  }
  participant.correction.send(*advance.mutable_impulses());
  participant.connection->post(participant.request);
}

void receive_prediction(Participant& participant) {
  collect(participant, wire::Frame::kPredicted);
  require_as_asked(participant);
  const wire::Predicted& predicted = participant.prediction();
  participant.compute_s += predicted.compute_seconds();
  participant.hidden_s += predicted.hidden_seconds();
  participant.cracks.insert(participant.cracks.end(), predicted.cracks().begin(), predicted.cracks().end());
  for (const wire::BondForce& force : predicted.strongest())
    if (force.force() > participant.strongest.force()) participant.strongest = force;
  std::copy(predicted.velocities().begin(), predicted.velocities().end(), participant.predicted.begin());
  std::ranges::fill(participant.correction.impulses_from(participant.nodes_begin), 0.0);
}

void correct_velocities(Participant& participant) {
  const Interpolation& n = *participant.interpolation;
  n.gather(participant.correction.impulses(), participant.own);
  n.divide_by_mass(participant.own);
  n.interpolate(participant.own, participant.corrected);
  for (std::size_t i = 0; i < participant.corrected.size(); ++i)
    participant.corrected[i] += participant.predicted[i];
}

std::vector<wire::Snapshot> take_snapshots(std::vector<Participant>& participants) {
  for (Participant& participant : participants) {
    // All are asked before the first answer is read, so that they work at the same time.
    participant.correction.send(*participant.request.mutable_snapshot_request()->mutable_impulses());
    participant.connection->post(participant.request);
  }
  std::vector<wire::Snapshot> snapshots;
  std::set<std::string> taken;  // names of pieces
  for (Participant& participant : participants) {
    collect(participant, wire::Frame::kSnapshot);
    require_drawable(participant, *participant.reply.mutable_snapshot(), taken);
    snapshots.push_back(std::move(*participant.reply.mutable_snapshot()));
  }
  return snapshots;
}

RoundTrip::RoundTrip(Model& model, StepCost& cost) : model_(model), cost_(cost) {
  for (Participant& participant : model.participants) order_.push_back(&participant);
  for (auto* vector : {&coarse_, &fine_, &multipliers_}) vector->resize(model.coupling_points.size());
}

void RoundTrip::run(const wire::Advance& request, const std::function<void()>& meanwhile) {
  {
    const Stopwatch waiting(cost_.wait);
    sort_slowest_first(order_);
    for (Participant* participant : order_)
      if (!participant->waits) post_advance(*participant, request);
    meanwhile();
    for (auto participant = order_.rbegin(); participant != order_.rend(); ++participant)
      if (!(*participant)->waits) receive_prediction(**participant);
  }
  if (model_.constraint) solve();
}

void RoundTrip::solve() {
  const Stopwatch solving(cost_.solve);
  Constraint& constraint = *model_.constraint;
  constraint.read(model_.participants, Part::kCoarse, &Participant::predicted, coarse_);
  constraint.read(model_.participants, Part::kFine, &Participant::predicted, fine_);
  constraint.solve(coarse_, fine_, multipliers_);
  for (const Part part : {Part::kCoarse, Part::kFine})
    constraint.assign(multipliers_, 1, part, model_.participants);
}

}  // namespace adit::coupler

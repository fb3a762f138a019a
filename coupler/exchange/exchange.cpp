#include "coupler/exchange/exchange.hpp"

#include <algorithm>
#include <set>
#include <string>

#include "coupler/exchange/as_asked.hpp"

namespace adit::coupler {
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

}  // namespace adit::coupler

#include "coupler/exchange/exchange.hpp"

#include <algorithm>
#include <string>

#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

// Participants are other programs, so the sizes of what they send are checked before use.
void require(const Participant& participant, const char* what, int found, std::size_t expected) {
  if (static_cast<std::size_t>(found) != expected)
    throw protocol::PeerLost(participant.connection->name(), "predicted " + std::to_string(found) + " " +
                                                                 what + " where " + std::to_string(expected) +
                                                                 " were expected");
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
  const wire::Predicted& predicted = participant.prediction();
  participant.compute_s += predicted.compute_seconds();
  participant.hidden_s += predicted.hidden_seconds();
  participant.cracks.insert(participant.cracks.end(), predicted.cracks().begin(), predicted.cracks().end());
  for (const wire::BondForce& force : predicted.strongest())
    if (force.force() > participant.strongest.force()) participant.strongest = force;
  const wire::Advance& asked = participant.request.advance();
  if (predicted.step() != asked.step() || predicted.has_energies() != asked.want_energies())
    throw protocol::PeerLost(participant.connection->name(), "predicted something else than step " +
                                                                 std::to_string(asked.step()) +
                                                                 ", or not the energies that were asked for");
  if (predicted.has_relaxation() != asked.relax())
    throw protocol::PeerLost(participant.connection->name(),
                             asked.relax() ? "does not know statics: its answer has no relaxation"
                                           : "relaxes, which it was not asked for");
  require(participant, "velocities", predicted.velocities_size(), participant.predicted.size());
  require(participant, "histories", predicted.histories_size(),
          asked.want_histories() ? participant.histories : 0);
  const bool whole_step = asked.want_histories() || asked.want_energies();
  if (participant.member.role == Role::kParticles && whole_step &&
      (predicted.strongest().empty() || predicted.strongest().rbegin()->step() != asked.step()))
    throw protocol::PeerLost(participant.connection->name(),
                             "did not say the largest bond force of step " + std::to_string(asked.step()));
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
  for (Participant& participant : participants) {
    collect(participant, wire::Frame::kSnapshot);
    snapshots.push_back(std::move(*participant.reply.mutable_snapshot()));
  }
  return snapshots;
}

}  // namespace adit::coupler

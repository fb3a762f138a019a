#include "coupler/stepping/exchange.hpp"

#include <algorithm>
#include <string>

#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

void fill(google::protobuf::RepeatedField<double>& field, const std::vector<double>& values) {
  field.Resize(static_cast<int>(values.size()), 0.0);
  std::copy(values.begin(), values.end(), field.mutable_data());
}

void require(const Side& side, const char* what, int found, std::size_t expected) {
  if (static_cast<std::size_t>(found) != expected)
    throw protocol::PeerLost(side.peer->name(), "predicted " + std::to_string(found) + " " + what +
                                                    " where " + std::to_string(expected) + " were expected");
}

}  // namespace

void post_advance(Side& side, const wire::Advance& request) {
  wire::Advance& advance = *side.request.mutable_advance();
  advance.CopyFrom(request);
  if (side.impulses_pending) fill(*advance.mutable_impulses(), side.impulses);
  side.impulses_pending = false;
  side.peer->post(side.request);
}

void receive_prediction(Side& side) {
  collect(side, wire::Frame::kPredicted);
  const wire::Predicted& predicted = side.prediction();
  side.compute_s += predicted.compute_seconds();
  side.hidden_s += predicted.hidden_seconds();
  side.cracks.insert(side.cracks.end(), predicted.cracks().begin(), predicted.cracks().end());
  for (const wire::BondForce& force : predicted.strongest())
    if (force.force() > side.strongest.force()) side.strongest = force;
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

void correct_velocities(Side& side) {
  const Interpolation& n = *side.interpolation;
  n.gather(side.impulses, side.own);
  n.divide_by_mass(side.own);
  n.interpolate(side.own, side.corrected);
  for (std::size_t i = 0; i < side.corrected.size(); ++i) side.corrected[i] += side.predicted[i];
}

std::vector<wire::Snapshot> take_snapshots(std::vector<Side>& sides) {
  for (Side& side : sides) {
    auto& request = *side.request.mutable_snapshot_request();
    if (side.impulses_pending) fill(*request.mutable_impulses(), side.impulses);
    side.impulses_pending = false;
    side.peer->post(side.request);
  }
  std::vector<wire::Snapshot> snapshots;
  for (Side& side : sides) {
    collect(side, wire::Frame::kSnapshot);
    snapshots.push_back(std::move(*side.reply.mutable_snapshot()));
  }
  return snapshots;
}

}  // namespace adit::coupler

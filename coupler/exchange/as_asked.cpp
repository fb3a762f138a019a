#include "coupler/exchange/as_asked.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <vector>

#include "protocol/errors.hpp"
#include "protocol/participant/history.hpp"
#include "protocol/results/vtk.hpp"

namespace adit::coupler {
namespace {

void require(const Participant& participant, const char* what, int found, std::size_t expected) {
  if (static_cast<std::size_t>(found) != expected)
    throw protocol::PeerLost(participant.connection->name(), "predicted " + std::to_string(found) + " " +
                                                                 what + " where " + std::to_string(expected) +
                                                                 " were expected");
}

// Quantities of what may be gone: a circle without particles, the face of a joint, a sector of an oval.
bool may_be_missing(scene::Quantity quantity) {
  switch (quantity) {
    case scene::STRAIN_RATE_XX:
    case scene::STRAIN_RATE_YY:
    case scene::SHEAR_STRAIN_RATE_XY:
    case scene::COORDINATION:
    case scene::POROSITY:
    case scene::OPENING:
    case scene::OFFSET:
    case scene::ROTATION:
    case scene::LARGEST_DIAMETER_CHANGE:
    case scene::SMALLEST_DIAMETER_CHANGE:
    case scene::LARGEST_DIAMETER_DIRECTION:
      return true;
    default:
      return false;
  }
}

void require_numbers(const Participant& participant, const google::protobuf::RepeatedField<double>& values) {
  for (int i = 0; i < values.size(); ++i) {
    const scene::Quantity quantity = participant.histories[static_cast<std::size_t>(i)];
    if (!std::isfinite(values[i]) && !(std::isnan(values[i]) && may_be_missing(quantity)))
      throw protocol::PeerLost(
          participant.connection->name(),
          fmt::format("sent {} as the {} of history {}", values[i], protocol::name_of(quantity), i));
  }
}

constexpr double kSpeedOfLight = 299792458;  // [m/s]

// What moves faster than light is unstable or wrong. It is told of here, because the impulses that it causes
// would soon break another participant.
void require_possible(const Participant& participant, const wire::Predicted& predicted) {
  for (int i = 0; i < predicted.velocities_size(); ++i)
    if (const double velocity = predicted.velocities(i); std::abs(velocity) > kSpeedOfLight) {
      const auto point = static_cast<std::size_t>(i - i % 2);
      throw protocol::Unstable(fmt::format(
          "{}: step {}: predicts a velocity of {:g} m/s at ({:g}, {:g}) m, faster than light; choose "
          "a smaller time.dt_factor; a program of your own must not send it",
          participant.connection->name(), predicted.step(), velocity, participant.places[point],
          participant.places[point + 1]));
    }
}

// The columns of energies.csv stay what they were at first.
void require_same_shares(Participant& participant, const wire::Energies& energies) {
  std::vector<std::string> names;
  for (const wire::EnergyShare& share : energies.shares()) names.push_back(share.name());
  if (!participant.shares) participant.shares = names;
  if (*participant.shares != names)
    throw protocol::PeerLost(participant.connection->name(),
                             fmt::format("sent other shares of the energy than before: {} instead of {}",
                                         fmt::join(names, ", "), fmt::join(*participant.shares, ", ")));
}

}  // namespace

void require_as_asked(Participant& participant) {
  const wire::Predicted& predicted = participant.prediction();
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
  require_possible(participant, predicted);
  require(participant, "histories", predicted.histories_size(),
          asked.want_histories() ? participant.histories.size() : 0);
  require_numbers(participant, predicted.histories());
  if (predicted.has_energies()) require_same_shares(participant, predicted.energies());
  const bool whole_step = asked.want_histories() || asked.want_energies();
  if (participant.member.role == Role::kParticles && whole_step &&
      (predicted.strongest().empty() || predicted.strongest().rbegin()->step() != asked.step()))
    throw protocol::PeerLost(participant.connection->name(),
                             "did not say the largest bond force of step " + std::to_string(asked.step()));
}

void require_drawable(const Participant& participant, wire::Snapshot& snapshot,
                      std::set<std::string>& taken) {
  const auto refuse = [&](const std::string& what) {
    throw protocol::PeerLost(participant.connection->name(), "sent a snapshot that cannot be drawn: " + what);
  };
  for (wire::Piece& piece : *snapshot.mutable_pieces()) {
    if (is_region(participant.member)) piece.set_name(participant.member.name + "_" + piece.name());
    if (const auto wrong = results::wrong_with(piece)) refuse(*wrong);
    if (!taken.insert(piece.name()).second) refuse("a second piece is named `" + piece.name() + "`");
  }
}

}  // namespace adit::coupler

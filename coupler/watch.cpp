#include "coupler/watch.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <utility>
#include <vector>

#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

// A run is unstable if the energy that no work explains exceeds this share of the peak energy. The time
// integration does not create as much in stable runs; an unstable run exceeds it within a few steps. Nor does
// it lose as much of the energy that was turned over: the runs of the cases lose 1e-3 at most.
constexpr double kRunawayShare = 0.2;

struct Fastest {
  double x = 0, y = 0, speed = -1;  // [m], [m/s]; a speed of NaN counts as infinite
  std::size_t participant = 0;
};

// The velocities of a piece's points, or none.
const wire::Field* velocities(const wire::Piece& piece) {
  for (const wire::Field& field : piece.point_fields())
    if (field.name() == "velocity_m_per_s" && field.components() >= 2 &&
        field.values_size() / static_cast<int>(field.components()) == piece.points_size() / 2)
      return &field;
  return nullptr;
}

Fastest find_fastest(const std::vector<wire::Snapshot>& snapshots) {
  Fastest fastest;
  for (std::size_t s = 0; s < snapshots.size(); ++s)
    for (const wire::Piece& piece : snapshots[s].pieces()) {
      const wire::Field* field = velocities(piece);
      if (!field) continue;
      const int size = static_cast<int>(field->components());
      for (int i = 0; i < piece.points_size() / 2; ++i) {
        const double speed = std::hypot(field->values(size * i), field->values(size * i + 1));
        if (!(speed <= fastest.speed)) fastest = {piece.points(2 * i), piece.points(2 * i + 1), speed, s};
      }
    }
  return fastest;
}

// What helps depends on what runs away.
std::string remedy(const Model& model, const Participant& fastest) {
  std::string text = "choose a smaller time.dt_factor";
  if (model.substeps > 1) text += ", or `time.substeps: 1`";
  if (fastest.member.role == Role::kParticles)
    text +=
        "; if it stops at the same time whatever the step, look for loose particles "
        "(particles.remove_floaters) "
        "and for contacts without damping there (contacts.normal_damping)";
  return text;
}

}  // namespace

void Watch::look(std::uint64_t n) {
  const Ledger::Loss loss = stepper_.ledger().loss();
  // Written so that what is not a number ends the run.
  if (!(stepper_.ledger().drift() <= kRunawayShare)) end_growing(n);
  if (!(loss.share <= kRunawayShare)) end_losing(n, loss);
  last_good_ = n;
}

void Watch::end_growing(std::uint64_t n) {
  std::vector<wire::Snapshot> snapshots = stepper_.snapshots();
  const Fastest fastest = find_fastest(snapshots);
  if (std::isfinite(fastest.speed)) recorder_.record_fields(n, std::move(snapshots));
  const Participant& where = model_.participants[fastest.participant];
  throw protocol::Unstable(
      fmt::format("step {} (t = {:g} s): the energy of the model exceeds the work done on it by {:.0f} % "
                  "of its peak; the fastest point is at ({:g}, {:g}) m of `{}` with {:g} m/s; {}; the run is "
                  "unstable: {}",
                  n, time_of(n), 100 * stepper_.ledger().drift(), fastest.x, fastest.y, where.member.name,
                  fastest.speed, last_good(), remedy(model_, where)));
}

void Watch::end_losing(std::uint64_t n, const Ledger::Loss& loss) {
  recorder_.record_fields(n, stepper_.snapshots());
  const Participant& where = model_.participants[loss.participant];
  throw protocol::Unstable(fmt::format(
      "step {} (t = {:g} s): {:.0f} % of the energy that the models took up is gone, most of it in `{}` "
      "({}), "
      "and nothing accounts for it: it is neither stored nor dissipated, nor did loads or the coupling take "
      "it; {}; check the units of stresses, loads and stiffness; a program of your own must report what its "
      "damping takes as `dissipated`",
      n, time_of(n), 100 * loss.share, where.member.name, where.connection->name(), last_good()));
}

std::string Watch::last_good() const {
  return fmt::format("energies were balanced until t = {:g} s", time_of(last_good_));
}

}  // namespace adit::coupler

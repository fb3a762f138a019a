#include "coupler/run.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "coupler/output/motion_outputs.hpp"
#include "coupler/output/recorder.hpp"
#include "coupler/output/schedule.hpp"
#include "coupler/participants/set_up.hpp"
#include "coupler/stepping/progress.hpp"
#include "coupler/stepping/statics.hpp"
#include "coupler/stepping/stepper.hpp"
#include "protocol/errors.hpp"
#include "protocol/results/atomic_file.hpp"
#include "protocol/results/run_directory.hpp"

namespace adit::coupler {
namespace {

// A run is unstable if the energy that no work explains exceeds this share of the peak energy. The time
// integration does not create as much in stable runs; an unstable run exceeds it within a few steps.
constexpr double kRunawayShare = 0.2;

// With substeps the ledger extrapolates the impulse in progress, so that its energy oscillates, by a tenth at
// most.
constexpr double kRunawayShareOfSubsteps = 0.5;

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

// Looks at the energy of the steps that want energies, and knows the last one that was good.
class Watch {
 public:
  Watch(Stepper& stepper, const Model& model, Recorder& recorder)
      : stepper_(stepper), model_(model), recorder_(recorder) {}

  // Ends the run where the energy grows by itself; the fields of now are written before, where they are
  // numbers.
  void look(std::uint64_t n) {
    const double excess = stepper_.ledger().excess();
    if (excess <= (model_.substeps > 1 ? kRunawayShareOfSubsteps : kRunawayShare)) {
      last_good_ = n;
      return;
    }
    std::vector<wire::Snapshot> snapshots = stepper_.snapshots();
    const Fastest fastest = find_fastest(snapshots);
    if (std::isfinite(fastest.speed)) recorder_.record_fields(n, std::move(snapshots));
    const Participant& where = model_.participants[fastest.participant];
    throw protocol::Unstable(
        fmt::format("step {} (t = {:g} s): the energy of the model exceeds the work done on it by {:.0f} % "
                    "of its peak; the "
                    "fastest point is at ({:g}, {:g}) m of `{}` with {:g} m/s; {}; the run is unstable: {}",
                    n, time_of(n), 100 * excess, fastest.x, fastest.y, where.member.name, fastest.speed,
                    last_good(), remedy(model_, where)));
  }
  std::string last_good() const {
    return fmt::format("energies were balanced until t = {:g} s", time_of(last_good_));
  }

 private:
  double time_of(std::uint64_t n) const { return static_cast<double>(n) * model_.dt; }

  Stepper& stepper_;
  const Model& model_;
  Recorder& recorder_;
  std::uint64_t last_good_ = 0;
};

void step_to_the_end(Model& model, const Schedule& schedule, Stepper& stepper, Recorder& recorder,
                     MotionOutputs& motions, std::uint64_t& reached) {
  Progress progress(model.steps, model.dt);
  Watch watch(stepper, model, recorder);
  for (std::uint64_t n = 0; n <= model.steps; ++n) {
    try {
      stepper.step(n, schedule.wanted(n));
    } catch (const protocol::Unstable& error) {  // of a participant, which knows its own part only
      throw protocol::Unstable(fmt::format("{}; {}", error.what(), watch.last_good()));
    }
    recorder.record_events();
    if (schedule.wants_row(n)) {
      const auto values = recorder.record_histories(n, stepper.ledger());
      if (schedule.is_sample(n)) motions.take(values);
    }
    if (schedule.watches(n)) watch.look(n);
    if (schedule.wants_fields(n)) recorder.record_fields(n, stepper.snapshots());
    reached = n;
    progress.update(n);
  }
}

}  // namespace

void run(const scene::Scene& scene, std::vector<Participant> participants, const RunLabels& labels,
         const std::filesystem::path& directory) {
  const auto start = std::chrono::steady_clock::now();
  Model model = set_up(scene, std::move(participants), labels.case_name + "/" + scene.name());
  const Schedule schedule(model);
  MotionOutputs motions(model, schedule.interval());
  results::clear_results(directory);  // only now, because a set-up that fails leaves the older results
  results::replace_file(directory / "scene.yaml", labels.scene_yaml);
  if (!labels.scene_as_written.empty())
    results::replace_file(directory / "scene_as_written.yaml", labels.scene_as_written);
  Stepper stepper(model);
  Recorder recorder(directory, model);
  RunSummary summary(labels, model);
  const auto stepping_start = std::chrono::steady_clock::now();
  std::uint64_t reached = 0;
  const auto conclude = [&](const std::string& error) {
    const auto now = std::chrono::steady_clock::now();
    summary.add_outcome(stepper, recorder.findings(), reached,
                        std::chrono::duration<double>(now - start).count(),
                        std::chrono::duration<double>(now - stepping_start).count(), error);
    summary.write(directory / "summary.json");
  };
  try {
    if (scene.has_statics()) summary.add_statics(relax(model, stepper));
    step_to_the_end(model, schedule, stepper, recorder, motions, reached);
    finish(model.participants);
    for (const Participant& participant : model.participants)
      summary.add_participant(participant, participant.reply.bye());
    summary.add_motions(motions.write(directory / "spectra"));
  } catch (const std::exception& error) {
    try {
      conclude(error.what());
      fmt::print("results            {}\n", directory.string());  // those until the error
    } catch (const std::exception& second) {  // for example a full disk; the first error is the one to report
      fmt::print(stderr, "the summary could not be written: {}\n", second.what());
    }
    throw;
  }
  conclude("");
  summary.print(directory);
}

}  // namespace adit::coupler

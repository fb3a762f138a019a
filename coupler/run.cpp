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
};

Fastest find_fastest(const std::vector<wire::Snapshot>& snapshots) {
  Fastest fastest;
  for (const wire::Snapshot& snapshot : snapshots)
    for (const wire::Piece& piece : snapshot.pieces())
      for (const wire::Field& field : piece.point_fields()) {
        const int size = static_cast<int>(field.components());
        if (field.name() != "velocity_m_per_s" || size < 2 ||
            field.values_size() / size != piece.points_size() / 2)
          continue;
        for (int i = 0; i < piece.points_size() / 2; ++i) {
          const double speed = std::hypot(field.values(size * i), field.values(size * i + 1));
          if (!(speed <= fastest.speed)) fastest = {piece.points(2 * i), piece.points(2 * i + 1), speed};
        }
      }
  return fastest;
}

void require_bounded_energy(Stepper& stepper, const Model& model, std::uint64_t n) {
  const double drift = stepper.ledger().drift();
  if (drift <= (model.substeps > 1 ? kRunawayShareOfSubsteps : kRunawayShare)) return;
  const Fastest fastest = find_fastest(stepper.snapshots());
  throw protocol::Unstable(fmt::format(
      "step {} (t = {:g} s): the energy of the model exceeds the work done on it by {:.0f} % of its "
      "peak; the fastest point is at ({:g}, {:g}) m with {:g} m/s; the run is unstable, choose a smaller "
      "time.dt_factor",
      n, static_cast<double>(n) * model.dt, 100 * drift, fastest.x, fastest.y, fastest.speed));
}

void step_to_the_end(Model& model, const Schedule& schedule, Stepper& stepper, Recorder& recorder,
                     MotionOutputs& motions, std::uint64_t& reached) {
  Progress progress(model.steps, model.dt);
  for (std::uint64_t n = 0; n <= model.steps; ++n) {
    stepper.step(n, schedule.wanted(n));
    recorder.record_events();
    if (schedule.wants_row(n)) {
      const auto values = recorder.record_histories(n, stepper.ledger());
      if (schedule.is_sample(n)) motions.take(values);
    }
    if (schedule.watches(n)) require_bounded_energy(stepper, model, n);
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
    } catch (const std::exception& second) {  // for example a full disk; the first error is the one to report
      fmt::print(stderr, "the summary could not be written: {}\n", second.what());
    }
    throw;
  }
  conclude("");
  summary.print(directory);
}

}  // namespace adit::coupler

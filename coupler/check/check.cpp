#include "coupler/check/check.hpp"

#include <spdlog/fmt/fmt.h>

#include <chrono>

#include "coupler/check/expectations.hpp"
#include "coupler/check/pace.hpp"
#include "coupler/check/savings.hpp"
#include "coupler/check/text.hpp"
#include "coupler/check/volume.hpp"
#include "coupler/check/warnings.hpp"
#include "coupler/output/motion_outputs.hpp"
#include "coupler/output/recorder.hpp"
#include "coupler/output/schedule.hpp"
#include "coupler/participants/set_up.hpp"
#include "coupler/stepping/stepper.hpp"
#include "protocol/errors.hpp"
#include "protocol/results/atomic_file.hpp"
#include "protocol/results/run_directory.hpp"

namespace adit::coupler {
namespace {

void write_undeformed(Model& model, const std::string& scene_yaml, const std::filesystem::path& directory) {
  results::clear_results(directory);
  results::replace_file(directory / "scene.yaml", scene_yaml);
  results::Collection fields(directory / "fields");
  write_fields(model, 0, take_snapshots(model.participants), fields);
}

void print_accuracy(const scene::Scene& scene) {
  if (!scene.has_accuracy()) return;
  print_line("accuracy",
             fmt::format("adit run refines the scene until {} answers are within {:g} %, for at most {}; "
                         "coupler run computes it once",
                         scene.questions_size(), 100 * scene.accuracy().within(),
                         clock_time(scene.accuracy().budget())));
}

}  // namespace

void check(const scene::Scene& scene, std::vector<Participant> participants, const std::string& scene_yaml,
           const std::filesystem::path& directory) {
  const auto start = std::chrono::steady_clock::now();
  if (std::filesystem::exists(directory / "summary.json"))
    throw protocol::UserError(
        "", "the directory " + directory.string() + " holds the results of a run; give another one by --out");
  Model model = set_up(scene, std::move(participants), "check/" + scene.name());
  const Schedule schedule(model);
  const MotionOutputs motions(model, schedule.interval());  // refuses what the run would refuse
  const std::chrono::duration<double> set_up_time = std::chrono::steady_clock::now() - start;
  compare_ground(model);
  compare_motions(model);
  schedule.compare(model);
  if (!directory.empty()) write_undeformed(model, scene_yaml, directory);
  print_counts(model);
  Stepper stepper(model);
  Pace pace = measure_pace(model, schedule, stepper);
  pace.set_up = set_up_time.count();
  Volume volume;
  if (pace.stable()) volume = measure_volume(model, schedule, stepper.snapshots());
  print_expectations(model, schedule, pace, volume);
  if (pace.stable()) print_savings(model, schedule, pace);
  print_accuracy(scene);
  print_notes_and_warnings(model, pace);
  if (pace.stable()) finish(model.participants);
}

}  // namespace adit::coupler

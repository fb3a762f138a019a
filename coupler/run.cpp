#include "coupler/run.hpp"

#include <spdlog/fmt/fmt.h>

#include <chrono>
#include <exception>
#include <functional>
#include <string>
#include <utility>

#include "coupler/check/warnings.hpp"
#include "coupler/checkpoint/transfer.hpp"
#include "coupler/output/capacities.hpp"
#include "coupler/output/motion_outputs.hpp"
#include "coupler/output/recorder.hpp"
#include "coupler/output/schedule.hpp"
#include "coupler/participants/set_up.hpp"
#include "coupler/run_state.hpp"
#include "coupler/stepping/progress.hpp"
#include "coupler/stepping/statics.hpp"
#include "coupler/stepping/stepper.hpp"
#include "coupler/watch.hpp"
#include "protocol/errors.hpp"
#include "protocol/release.hpp"
#include "protocol/results/atomic_file.hpp"
#include "protocol/results/disk/reserve.hpp"
#include "protocol/results/run_directory.hpp"
#include "protocol/standard_streams.hpp"
#include "protocol/stop_signals.hpp"

namespace adit::coupler {
namespace {

using Clock = std::chrono::steady_clock;
using Begin = results::GrowingFile::Begin;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Only after the set-up, because a set-up that fails leaves the older results.
const std::filesystem::path& begin_results(const std::filesystem::path& directory, const RunLabels& labels,
                                           Begin begin) {
  if (begin == Begin::kAnew) results::clear_results(directory);
  results::replace_file(directory / "scene.yaml", labels.scene_yaml);
  if (!labels.scene_as_written.empty())
    results::replace_file(directory / "scene_as_written.yaml", labels.scene_as_written);
  return directory;
}

void note_what_saves_no_state(Model& model) {
  for (const Participant& participant : model.participants) {
    if (!participant.model.state_format().empty()) continue;
    model.notes.push_back("checkpoint: none can be written, because " + participant.connection->name() +
                          " (" + participant.member.name + ") does not save its state");
    protocol::print_error(fmt::format("note: {}\n", model.notes.back()));
  }
}

Model set_up_from(const std::optional<From>& from, const scene::Scene& scene,
                  std::vector<Participant> participants, const RunLabels& labels) {
  const bool goes_on = from && from->same_run;
  Model model = set_up(scene, std::move(participants), labels.case_name + "/" + scene.name(),
                       goes_on ? from->checkpoint.manifest.dt : 0);
  note_what_saves_no_state(model);
  compare_ground(model);
  compare_motions(model);
  return model;
}

// Wall-clock time between two checkpoints, where the scene asks for them.
std::optional<std::chrono::duration<double>> interval_of(const scene::Scene& scene) {
  if (!scene.output().has_checkpoint()) return std::nullopt;
  return std::chrono::duration<double>(scene.output().checkpoint().interval());
}

// One run and all that it knows.
class Run {
 public:
  Run(const scene::Scene& scene, std::vector<Participant> participants, const RunLabels& labels,
      const std::filesystem::path& directory, std::optional<From> from);
  void go();

 private:
  void step_to_the_end();
  void step(std::uint64_t n);
  void pause_statics(bool at_rest);
  void pause();
  bool save_is_due() const { return checkpoints_.due() || protocol::stop_requested(); }
  void save(const std::string& name);
  void end_early(const std::exception& error);
  void write_last_fields();
  void conclude(const std::string& error);
  std::uint64_t reached() const { return state_.next_step > 0 ? state_.next_step - 1 : 0; }  // step of time
  double wall_s() const { return wall_before_ + seconds_since(start_); }
  double stepping_s() const { return stepping_before_ + seconds_since(stepping_start_); }

  Clock::time_point start_ = Clock::now();
  double wall_before_ = 0, stepping_before_ = 0, restore_s_ = 0;  // of a run that goes on [s]
  const RunLabels& labels_;
  std::filesystem::path directory_;
  Model model_;
  Begin begin_;
  Schedule schedule_;
  MotionOutputs motions_;
  Stepper stepper_;
  Recorder recorder_;
  std::optional<Statics> statics_;
  Watch watch_;
  Checkpoints checkpoints_;
  RunState state_;
  RunSummary summary_;
  results::Reserve reserve_;
  Clock::time_point stepping_start_ = Clock::now();
};

Run::Run(const scene::Scene& scene, std::vector<Participant> participants, const RunLabels& labels,
         const std::filesystem::path& directory, std::optional<From> from)
    : labels_(labels),
      directory_(directory),
      model_(set_up_from(from, scene, std::move(participants), labels)),
      begin_(from && from->same_run ? Begin::kGoOn : Begin::kAnew),
      schedule_(model_, from && from->same_run ? from->checkpoint.manifest.history_stride : 0),
      motions_(model_, schedule_.interval()),
      stepper_(model_),
      recorder_(begin_results(directory, labels, begin_), model_, begin_),
      watch_(stepper_, model_, recorder_),
      checkpoints_(directory, interval_of(scene)),
      state_{
          .model = model_, .stepper = stepper_, .recorder = recorder_, .motions = motions_, .watch = watch_},
      summary_(labels, model_),
      reserve_(directory) {
  schedule_.compare(model_);
  if (begin_ == Begin::kAnew) write_capacities(scene, directory_ / "capacities.csv");
  for (const std::string& warning : warnings_before(model_)) summary_.warn(warning);
  if (scene.has_statics()) state_.statics = &statics_.emplace(model_, stepper_);
  if (!from) return;
  const Clock::time_point restore_start = Clock::now();
  state_.restore(from->checkpoint, from->same_run);
  restore_s_ = seconds_since(restore_start);
  if (!from->same_run) return;
  wall_before_ = from->checkpoint.manifest.wall_s;
  stepping_before_ = state_.stepping_s;
}

void Run::go() {
  const protocol::StopSignals signals;
  try {
    if (statics_) {
      if (state_.next_step == 0) statics_->run([this](bool at_rest) { pause_statics(at_rest); });
      summary_.add_statics(statics_->rest());
    }
    step_to_the_end();
    finish(model_.participants);
    for (const Participant& participant : model_.participants)
      summary_.add_participant(participant, participant.reply.bye());
    recorder_.record_crack_paths();
    summary_.add_motions(motions_.write(directory_ / "spectra"));
  } catch (const std::exception& error) {
    end_early(error);
    throw;
  }
  conclude("");
  summary_.print(directory_);
}

// Writes what can still be written. A later error, such as a lost server, must not hide the one to report.
void Run::end_early(const std::exception& error) {
  const auto attempt = [](const char* what, const std::function<void()>& write) {
    try {
      write();
    } catch (const std::exception& second) {
      protocol::print_error(fmt::format("{} could not be written: {}\n", what, second.what()));
    }
  };
  const auto* refused = dynamic_cast<const protocol::UserError*>(&error);
  const bool no_rest = refused != nullptr && refused->path() == "statics";
  if (no_rest || dynamic_cast<const protocol::Stopped*>(&error) != nullptr)
    attempt("the last fields", [this] { write_last_fields(); });
  attempt("the summary", [&] { conclude(error.what()); });
  protocol::print(fmt::format("results            {}\n", directory_.string()));  // those until the error
  if (checkpoints_.any()) protocol::print(fmt::format("go on by           {}\n", labels_.resume_command));
}

void Run::step_to_the_end() {
  Progress progress(model_.steps, model_.dt, state_.next_step);
  while (state_.next_step <= model_.steps) {
    const std::uint64_t n = state_.next_step;
    step(n);
    progress.update(n);
    ++state_.next_step;
    if (n < model_.steps)
      pause();
    else if (checkpoints_.asked_for())
      save(fmt::format("step_{}", n));
  }
}

void Run::step(std::uint64_t n) {
  try {
    stepper_.step(n, schedule_.wanted(n));
  } catch (const protocol::Unstable& error) {  // of a participant, which knows its own part only
    throw protocol::Unstable(fmt::format("{}; {}", error.what(), watch_.last_good()));
  }
  recorder_.record_events();
  if (schedule_.wants_row(n)) {
    const auto values = recorder_.record_histories(n, stepper_.ledger());
    if (schedule_.is_sample(n)) motions_.take(values);
  }
  if (schedule_.watches(n)) watch_.look(n);
  if (schedule_.wants_fields(n)) recorder_.record_fields(n, stepper_.snapshots());
}

// Between two steps of statics.
void Run::pause_statics(bool at_rest) {
  if ((at_rest && checkpoints_.asked_for()) || save_is_due())
    save(statics_->done() ? "at_rest" : fmt::format("statics_{}", statics_->rest().steps));
  protocol::end_if_stopped();
}

void Run::pause() {
  if (save_is_due()) save(fmt::format("step_{}", reached()));
  protocol::end_if_stopped();
}

void Run::save(const std::string& name) {
  if (!all_save_states(model_.participants)) return;
  state_.stepping_s = stepping_s();
  checkpoints_.write(name,
                     {.release = std::string(protocol::release()),
                      .scene_hash = hash_of(model_.scene),
                      .at_rest = state_.next_step == 0 && statics_ && statics_->done(),
                      .step = reached(),
                      .time = static_cast<double>(reached()) * model_.dt,
                      .dt = model_.dt,
                      .history_stride = schedule_.stride(),
                      .wall_s = wall_s(),
                      .case_name = labels_.case_name,
                      .notes = labels_.notes,
                      .origin = labels_.origin,
                      .resumed = state_.resumed},
                     model_.participants, state_.save());
}

void Run::write_last_fields() {
  const bool in_statics = state_.next_step == 0;
  if (in_statics || !schedule_.wants_fields(reached()))
    recorder_.record_fields(reached(), stepper_.snapshots());
}

void Run::conclude(const std::string& error) {
  reserve_.release();
  summary_.add_outcome(stepper_, recorder_.findings(), reached(), wall_s(), stepping_s(), error);
  if (!error.empty() && checkpoints_.any()) summary_.add_resume(labels_.resume_command);
  summary_.add_states(state_.resumed, checkpoints_.seconds(), restore_s_);
  summary_.write(directory_ / "summary.json");
}

}  // namespace

void run(const scene::Scene& scene, std::vector<Participant> participants, const RunLabels& labels,
         const std::filesystem::path& directory, std::optional<From> from) {
  Run(scene, std::move(participants), labels, directory, std::move(from)).go();
}

}  // namespace adit::coupler

#include "coupler/check/expectations.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "coupler/check/text.hpp"

namespace adit::coupler {
namespace {

// A snapshot is held as fields, and a part of it as bytes on their way.
constexpr double kSnapshotCopies = 1.3;

// The critical step of a participant in steps of the particles, as time_step.hpp compares them.
double critical_step(const Participant& participant, const Model& model) {
  const bool is_grid = participant.member.role == Role::kContinuum;
  return participant.model.critical_dt() / (is_grid ? model.substeps : 1);
}

void print_time_step(const Model& model) {
  const Participant& governing = *std::ranges::min_element(
      model.participants, {},
      [&](const Participant& participant) { return critical_step(participant, model); });
  const wire::Model& its = governing.model;
  const double step = model.dt / model.substeps;
  std::string where = its.critical_element().empty()
                          ? ""
                          : fmt::format(": {} at ({:.4g}, {:.4g}) m", its.critical_element(),
                                        its.critical_x(), its.critical_y());
  print_line("time step", fmt::format("{:.6g} s, {:.3g} of the critical one of the {}{}", step,
                                      step / model.critical_dt, governing.member.name, where));
  if (model.substeps > 1)
    print_line("substeps", fmt::format("{} in a step of {:.6g} s of the grid", model.substeps, model.dt));
  print_line("steps", fmt::format("{} for {:g} s", grouped(model.steps), model.scene.time().duration()));
}

void print_frequencies(const Model& model) {
  for (const Participant& participant : model.participants)
    if (const double highest = participant.model.highest_frequency(); highest > 0)
      print_line("carries", fmt::format("up to {:.3g} Hz in the {}", highest, participant.member.name));
}

// The most that each process will hold: its model, and the snapshots of one time.
void print_memory(const Model& model, const Volume& volume) {
  std::string text;
  for (std::size_t s = 0; s < model.participants.size(); ++s) {
    const Participant& participant = model.participants[s];
    if (const auto bytes = static_cast<double>(participant.counts.resident_bytes()); bytes > 0)
      text += fmt::format("{} for the {}, ", memory(bytes + kSnapshotCopies * volume.snapshot_bytes[s]),
                          participant.member.name);
  }
  print_line("memory", fmt::format("{}{} for the coupler", text, memory(volume.coupler_bytes)));
}

void print_time(const Model& model, const Schedule& schedule, const Pace& pace, const Volume& volume) {
  const double steps = pace.step * static_cast<double>(model.steps);
  const double fields = volume.field_seconds * static_cast<double>(schedule.field_count());
  std::string text = fmt::format("{}: {} steps of {:.3g} ms, {} for set-up and results",
                                 clock_time(steps + fields + pace.set_up), grouped(model.steps),
                                 1e3 * pace.step, clock_time(fields + pace.set_up));
  if (pace.relaxing > 0)
    text += fmt::format("; before that {} for every 1,000 steps of statics", clock_time(1e3 * pace.relaxing));
  print_line("time to expect", text);
}

}  // namespace

void print_expectations(const Model& model, const Schedule& schedule, const Pace& pace,
                        const Volume& volume) {
  print_time_step(model);
  print_frequencies(model);
  if (!pace.stable()) return;
  print_memory(model, volume);
  print_line("results", fmt::format("{} on disk: histories in {} rows of {} columns, fields at {} times",
                                    memory(volume.bytes(schedule)), grouped(schedule.row_count()),
                                    volume.history_columns, schedule.field_count()));
  print_time(model, schedule, pace, volume);
}

}  // namespace adit::coupler

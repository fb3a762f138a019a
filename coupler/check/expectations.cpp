#include "coupler/check/expectations.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "coupler/check/text.hpp"

namespace adit::coupler {
namespace {

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

void print_memory(const Model& model) {
  std::string text;
  for (const Participant& participant : model.participants)
    if (const double bytes = static_cast<double>(participant.counts.resident_bytes()); bytes > 0)
      text +=
          fmt::format("{}{} for the {}", text.empty() ? "" : ", ", memory(bytes), participant.member.name);
  if (!text.empty()) print_line("memory", text);
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
  print_memory(model);
  if (!pace.stable()) return;
  print_line("results", fmt::format("{} on disk: histories in {} rows of {} columns, fields at {} times",
                                    memory(volume.bytes(schedule)), grouped(schedule.row_count()),
                                    volume.history_columns, schedule.field_count()));
  print_time(model, schedule, pace, volume);
}

}  // namespace adit::coupler

#include "coupler/check/expectations.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "coupler/check/text.hpp"
#include "protocol/ground/stages.hpp"
#include "protocol/text.hpp"

namespace adit::coupler {
namespace {

using Table = std::vector<std::vector<std::string>>;

// The laws of contacts that the scene states: of the particles and of their groups.
std::string contacts_of(const scene::Particles& particles) {
  std::vector<scene::ParticleContacts> laws;
  if (particles.has_contacts()) laws.push_back(particles.contacts());
  for (const auto& group : particles.groups())
    if (group.has_contacts()) laws.push_back(group.contacts());
  if (laws.empty()) return "none";
  return laws.size() == 1 ? fmt::format("friction {:g}", laws[0].friction())
                          : fmt::format("{} laws", laws.size());
}

// Those after the beginning.
template <class Part>
std::string stages_in(const Part& part) {
  return grouped(protocol::stages_of(part).size() - 1);
}

std::vector<std::string> particles_row(const Participant& participant, const scene::Particles& particles) {
  const wire::Interface& counts = participant.counts;
  return {participant.member.name,
          grouped(counts.particles()),
          grouped(counts.bonds()),
          grouped(counts.breakable_bonds()),
          contacts_of(particles),
          grouped(static_cast<std::uint64_t>(particles.joints_size())),
          grouped(static_cast<std::uint64_t>(particles.springs_size())),
          stages_in(particles)};
}

std::vector<std::string> grid_row(const Participant& participant, const scene::Continuum& continuum) {
  return {participant.member.name,
          grouped(participant.counts.zones()),
          grouped(participant.counts.grid_points()),
          grouped(static_cast<std::uint64_t>(continuum.linings_size())),
          grouped(static_cast<std::uint64_t>(continuum.bolts_size())),
          stages_in(continuum)};
}

void print_if_any(const Table& table) {
  if (table.size() > 1) print_table(table);
}

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
  std::string text =
      fmt::format("{}: {} steps of {:.3g} ms{}, {} for set-up and results",
                  clock_time(steps + fields + pace.set_up), grouped(model.steps), 1e3 * pace.step,
                  pace.waiting ? " while particles wait, if they can" : "", clock_time(fields + pace.set_up));
  if (pace.relaxing > 0)
    text += fmt::format("; before that {} for every 1,000 steps of statics", clock_time(1e3 * pace.relaxing));
  print_line("time to expect", text);
}

}  // namespace

void print_counts(const Model& model) {
  Table particles{
      {"particles of", "particles", "bonds", "breakable", "contacts", "joints", "springs", "stages"}};
  Table grids{{"grid of", "zones", "grid points", "linings", "bolts", "stages"}};
  for (const Participant& participant : model.participants) {
    const scene::Scene part = part_of(model.scene, participant.member);
    if (participant.member.role == Role::kParticles)
      particles.push_back(particles_row(participant, part.particles()));
    else
      grids.push_back(grid_row(participant, part.continuum()));
  }
  Table interfaces{{"interface of", "coupling points", "solve"}};
  for (const Interface& interface : model.interfaces)
    interfaces.push_back({model.participants[interface.outer].member.name + ", " +
                              model.participants[interface.inner].member.name,
                          grouped(interface.end - interface.begin),
                          protocol::lower_case(scene::Solve_Name(interface.given.solve()))});
  print_if_any(particles);
  print_if_any(grids);
  print_if_any(interfaces);
  for (const Participant& participant : model.participants)
    if (!participant.model.engine().empty())
      print_line("engine", participant.member.name + ": " + participant.model.engine());
}

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

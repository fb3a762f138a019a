#include "coupler/output/recorder.hpp"

#include <algorithm>

#include "protocol/participant/history.hpp"

namespace adit::coupler {

namespace fs = std::filesystem;

std::vector<std::string> history_columns(const Model& model) {
  std::vector<std::string> columns = {"time_s"};
  for (const Participant& participant : model.participants)
    for (const auto& history : histories_of(model.scene, participant.member))
      columns.push_back(protocol::column_of(history));
  if (has_particles(model)) columns.emplace_back("max_bond_force_N");
  for (const Participant& participant : model.participants)
    for (const char* energy : {"_kinetic_J", "_strain_J", "_released_J", "_external_work_J",
                               "_multiplier_work_J", "_dissipated_J"})
      columns.push_back(participant.member.name + energy);
  columns.emplace_back("energy_drift");
  return columns;
}

std::vector<std::string> share_columns(const Model& model) {
  std::vector<std::string> columns = {"time_s"};
  for (const Participant& participant : model.participants)
    for (const wire::EnergyShare& share : participant.prediction().energies().shares())
      columns.push_back(participant.member.name + "_" + share.name() + "_J");
  return columns;
}

namespace {

std::ptrdiff_t regions_of_particles(const Model& model) {
  return std::ranges::count(model.participants, Role::kParticles,
                            [](const Participant& participant) { return participant.member.role; });
}

// Whether the bond joined two groups: the participant then tells none of its groups by name, but "a-b". One
// that names no groups has one body.
bool is_debonding(const wire::Crack& bond, const Participant& of) {
  const auto& groups = of.model.groups();
  return !groups.empty() && std::ranges::find(groups, bond.group()) == groups.end();
}

}  // namespace

void write_fields(const Model& model, std::uint64_t n, const std::vector<wire::Snapshot>& snapshots,
                  results::Collection& fields) {
  for (const wire::Snapshot& snapshot : snapshots)
    results::write_snapshot(n, static_cast<double>(n) * model.dt, snapshot, fields);
}

Recorder::Recorder(const std::filesystem::path& directory, Model& model, results::GrowingFile::Begin begin)
    : model_(model),
      directory_(directory),
      histories_(directory / "histories.csv", history_columns(model), begin),
      fields_(directory / "fields"),
      several_(regions_of_particles(model) > 1) {
  if (has_particles(model))
    cracks_.emplace(directory / "cracks.csv", results::crack_columns(several_), begin);
}

void Recorder::exchange(state::Archive& archive) {
  histories_.exchange(archive);
  std::uint64_t share_columns = shares_ ? shares_->columns() : 0;
  archive("share_columns", share_columns);
  const fs::path shares = directory_ / "energies.csv";
  if (archive.reads() && share_columns > 0)
    shares_.emplace(shares, share_columns);
  else if (archive.reads())
    fs::remove(shares);
  if (shares_) shares_->exchange(archive);
  if (cracks_) cracks_->exchange(archive);
  fields_.exchange(archive);
  findings_.exchange(archive);
}

void Findings::exchange(state::Archive& archive) {
  archive("peak_bond_force", peak_bond_force);
  archive("peak_event", peak);
  for (BrokenBonds* bonds : {&cracks, &debonded, &in_overlap}) bonds->exchange(archive);
}

void BrokenBonds::add(const Event& event) {
  if (count++ == 0) first = event;
}

void BrokenBonds::exchange(state::Archive& archive) {
  archive("broken_bonds", count);
  archive("first_event", first);
  std::vector<std::uint64_t> by_stage;
  for (const auto& [stage, bonds] : in_statics) by_stage.insert(by_stage.end(), {stage, bonds});
  archive("broken_in_statics", by_stage);
  in_statics.clear();
  for (std::size_t k = 0; k + 1 < by_stage.size(); k += 2)
    in_statics[static_cast<std::uint32_t>(by_stage[k])] = by_stage[k + 1];
}

void Recorder::record_events() {
  struct Broken {
    double time;
    const wire::Crack* crack;
    const Participant* of;
  };
  std::vector<Broken> broken;  // of all participants, whose steps may differ
  for (Participant& participant : model_.participants) {
    // Particles number their own steps, of which there are `substeps` in one step of the run.
    const double dt = participant.member.role == Role::kParticles ? model_.dt / model_.substeps : model_.dt;
    const auto time_of = [dt](std::uint64_t step) { return static_cast<double>(step) * dt; };
    if (participant.strongest.force() > findings_.peak_bond_force) {
      findings_.peak_bond_force = participant.strongest.force();
      findings_.peak = {time_of(participant.strongest.step()), participant.strongest.x(),
                        participant.strongest.y()};
    }
    for (const wire::Crack& crack : participant.cracks)
      broken.push_back({time_of(crack.step()), &crack, &participant});
    participant.strongest.Clear();
  }
  std::ranges::stable_sort(broken, {}, &Broken::time);
  for (const Broken& bond : broken) record_broken_bond(*bond.crack, bond.time, *bond.of);
  for (Participant& participant : model_.participants) participant.cracks.clear();
}

// Those of statics before the stage from which cracks count are only counted.
void Recorder::record_broken_bond(const wire::Crack& bond, double time, const Participant& of) {
  BrokenBonds& kind = is_debonding(bond, of) ? findings_.debonded : findings_.cracks;
  if (bond.in_statics()) {
    ++kind.in_statics[bond.stage()];
    if (bond.stage() < model_.scene.statics().count_from_stage()) return;
  }
  if (cracks_) results::write_crack(*cracks_, time, bond, several_ ? of.member.name : "");
  const Event event{time, bond.x(), bond.y()};
  kind.add(event);
  if (std::ranges::any_of(model_.interfaces, [&](const Interface& interface) {
        return interface.overlap.contains(bond.x(), bond.y());
      }))
    findings_.in_overlap.add(event);
}

std::span<const double> Recorder::record_histories(std::uint64_t n, const Ledger& ledger) {
  row_.assign(1, static_cast<double>(n) * model_.dt);
  for (const Participant& participant : model_.participants) {
    const auto& values = participant.prediction().histories();
    row_.insert(row_.end(), values.begin(), values.end());
  }
  if (has_particles(model_)) {
    double strongest = 0;
    for (const Participant& participant : model_.participants)
      if (participant.member.role == Role::kParticles)
        strongest = std::max(strongest, participant.prediction().strongest().rbegin()->force());
    row_.push_back(strongest);
  }
  // Where all that moves turns, and from rest, the velocities of half a step before and after are opposite:
  // their product is as far below 0 as the step is coarse, and nothing moves.
  for (const ParticipantEnergies& e : ledger.energies())
    row_.insert(row_.end(), {e.kinetic <= 0 ? 0 : e.kinetic, e.strain, e.released, e.external_work,
                             e.multiplier_work, e.dissipated});
  row_.push_back(ledger.drift());
  histories_.row(row_);
  record_shares();
  return row_;
}

// The file is opened with the first row, because only the first answers of the participants say which
// energies they report.
void Recorder::record_shares() {
  if (!shares_) {
    const auto columns = share_columns(model_);
    if (columns.size() == 1) return;
    shares_.emplace(directory_ / "energies.csv", columns);
  }
  share_row_.assign(1, row_.front());
  for (const Participant& participant : model_.participants)
    for (const wire::EnergyShare& share : participant.prediction().energies().shares())
      share_row_.push_back(share.value());
  shares_->row(share_row_);
}

void Recorder::record_crack_paths() const {
  const auto paths_of = [](const Participant& participant) -> const auto& {
    return participant.reply.bye().crack_paths();
  };
  if (std::ranges::all_of(model_.participants, [&](const Participant& one) { return paths_of(one).empty(); }))
    return;
  results::CsvFile file(directory_ / "crack_paths.csv", results::crack_path_columns(several_));
  for (const Participant& participant : model_.participants) {
    std::uint64_t number = 0;
    for (const wire::CrackPath& path : paths_of(participant))
      results::write_crack_path(file, ++number, path, several_ ? participant.member.name : "");
  }
}

void Recorder::record_fields(std::uint64_t n, const std::vector<wire::Snapshot>& snapshots) {
  write_fields(model_, n, snapshots, fields_);
}

}  // namespace adit::coupler

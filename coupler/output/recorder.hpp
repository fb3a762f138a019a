// The files that a run writes while it goes on: histories.csv, energies.csv (for participants that report the
// parts of their energy), cracks.csv, fields/; and at its end crack_paths.csv. Cracks of statics before the
// stage from which cracks count do not stand in cracks.csv.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coupler/participants/set_up.hpp"
#include "coupler/stepping/ledger.hpp"
#include "protocol/results/csv.hpp"
#include "protocol/results/vtk.hpp"

namespace adit::coupler {

struct Event {
  double time = 0, x = 0, y = 0;  // [s], [m]
};

struct BrokenBonds {
  std::uint64_t count = 0;
  Event first;
  std::map<std::uint32_t, std::uint64_t> in_statics;  // by stage of excavation, before time began

  void add(const Event& event);
  void exchange(state::Archive& archive);
};

// The largest bond force and the broken bonds so far: cracks are those inside one body, debonded are those
// between two groups. Broken bonds inside an overlap mean that a particle region is too small.
struct Findings {
  double peak_bond_force = 0;  // [N]
  Event peak;
  BrokenBonds cracks, debonded;
  BrokenBonds in_overlap;

  void exchange(state::Archive& archive);
};

// Columns of histories.csv, and of energies.csv: the latter once the participants have told their energies.
std::vector<std::string> history_columns(const Model& model);
std::vector<std::string> share_columns(const Model& model);

// Writes the snapshots of step n, one a participant.
void write_fields(const Model& model, std::uint64_t n, const std::vector<wire::Snapshot>& snapshots,
                  results::Collection& fields);

class Recorder {
 public:
  // Opens the files in `directory`, which must exist: anew, or to go on with them.
  Recorder(const std::filesystem::path& directory, Model& model,
           results::GrowingFile::Begin begin = results::GrowingFile::Begin::kAnew);

  // To be called in every step: records what the participants have reported since the last call.
  void record_events();
  std::span<const double> record_histories(std::uint64_t n,
                                           const Ledger& ledger);  // the row, valid until the next call
  void record_fields(std::uint64_t n,
                     const std::vector<wire::Snapshot>& snapshots);  // one for each participant

  // After the participants have ended: crack_paths.csv, where any has told of paths.
  void record_crack_paths() const;

  // How far the files are. One that reads takes away what came later.
  void exchange(state::Archive& archive);

  const Findings& findings() const { return findings_; }

 private:
  void record_broken_bond(const wire::Crack& bond, double time, const Participant& of);
  void record_shares();

  Model& model_;
  std::filesystem::path directory_;
  results::CsvFile histories_;
  std::optional<results::CsvFile> shares_;  // open once a participant has reported parts of its energy
  std::optional<results::CsvFile> cracks_;  // open if the model has particles
  results::Collection fields_;
  bool several_;  // regions of particles
  Findings findings_;
  std::vector<double> row_, share_row_;
};

}  // namespace adit::coupler

// The summary of a run: the model, the cost, the findings, the energy ledger.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "coupler/output/motion_outputs.hpp"
#include "coupler/output/recorder.hpp"
#include "coupler/stepping/statics.hpp"
#include "coupler/stepping/stepper.hpp"
#include "protocol/results/summary.hpp"

namespace adit::coupler {

struct RunLabels {
  std::string case_name;  // the summary's `case`
  std::string scene_hash;
  std::string versions;            // names and versions of all programs that take part
  std::string scene_yaml;          // the scene as it is computed
  std::string scene_as_written;    // with its tunnels; empty where it is computed as it was written
  std::vector<std::string> notes;  // on the scene
  protocol::Origin origin;
  std::string resume_command = {};  // that goes on with the run
};

class RunSummary {
 public:
  RunSummary(const RunLabels& labels, const Model& model);

  // Adds a warning, and tells it at once, because a run may take days.
  void warn(const std::string& warning);

  // Adds how the model came to rest before time began.
  void add_statics(const Rest& rest);

  // Adds the measures of the motions for which spectra were asked.
  void add_motions(const MotionOutputs::Found& found);

  // Adds what a participant reported at the end.
  void add_participant(const Participant& participant, const wire::Bye& bye);

  // Adds how the run ended. `steps` were computed in `stepping_s` of the `wall_s` seconds of the run; `error`
  // is empty for a complete run.
  void add_outcome(const Stepper& stepper, const Findings& findings, std::uint64_t steps, double wall_s,
                   double stepping_s, const std::string& error);

  // Adds the command that goes on with a run that ended early.
  void add_resume(const std::string& command) { summary_.set("resume", command); }

  // Adds the steps from which the run has gone on before, and what states took the last time [s]: to write,
  // to read.
  void add_states(const std::vector<std::uint64_t>& resumed, double written_s, double read_s);

  void write(const std::filesystem::path& path) const { summary_.write(path); }

  // Prints the main figures to standard output.
  void print(const std::filesystem::path& directory) const;

 private:
  // Adds the engines that compute the particles, and the notes on the scene and on the model.
  void add_engines();
  void add_names();
  void add_notes(std::vector<std::string> notes);
  void add_figures();
  void add_stated();
  void add_findings(const Findings& findings);
  void add_crack_paths();
  struct BrokenNames {
    const char *count, *first, *in_statics;
  };
  void add_broken_bonds(const BrokenNames& names, const BrokenBonds& bonds);
  void add_event(const std::string& name, const Event& event, bool happened);
  void add_cost(const Stepper& stepper, std::uint64_t steps, double wall_s, double stepping_s);
  void add_ledger(const Ledger& ledger);
  void add_waiting(const Stepper& stepper);  // of particles that begin later
  void add_warnings(const Findings& findings);

  const Model& model_;
  results::Summary summary_;
  std::uint64_t particle_updates_ = 0, zone_updates_ = 0;
  std::uint64_t crack_paths_ = 0;
  wire::CrackPath longest_path_;
  std::vector<std::pair<std::string, double>> figures_;  // of the participants
  std::vector<std::string> lines_, warnings_;            // the lines that print() writes
};

}  // namespace adit::coupler

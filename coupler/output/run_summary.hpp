// What the summary of a run says: the model, the cost, the findings, the ledger.
#pragma once

#include <filesystem>
#include <string>
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
  std::string versions;    // of all programs that take part
  std::string scene_yaml;  // what is computed
};

class RunSummary {
 public:
  RunSummary(const RunLabels& labels, const Model& model);

  // How the model came to rest before time began.
  void add_statics(const Rest& rest);

  // Measures of the motions that spectra were asked of.
  void add_motions(const MotionOutputs::Found& found);

  // What a participant said at the end.
  void add_participant(const Participant& participant, const wire::Bye& bye);

  // `steps` were computed in `stepping_s` of `wall_s` seconds; `error` is empty for a complete run.
  void add_outcome(const Stepper& stepper, const Findings& findings, std::uint64_t steps, double wall_s,
                   double stepping_s, const std::string& error);

  void write(const std::filesystem::path& path) const { summary_.write(path); }

  // The essence, for a person: on standard output.
  void print(const std::filesystem::path& directory) const;

 private:
  // What the participants say of their models.
  void add_engines();
  void add_notes();
  void add_findings(const Findings& findings);
  void add_event(const std::string& name, const Event& event, bool happened);
  void add_cost(const Stepper& stepper, std::uint64_t steps, double wall_s, double stepping_s);
  void add_ledger(const Ledger& ledger);
  void warn(const Findings& findings);

  const Model& model_;
  results::Summary summary_;
  std::uint64_t particle_updates_ = 0, zone_updates_ = 0;
  std::vector<std::string> lines_, warnings_;  // of print()
};

}  // namespace adit::coupler

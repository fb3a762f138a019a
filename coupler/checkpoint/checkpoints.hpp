// The checkpoints of a run: a folder each below `checkpoints/` of its results, NNNNNN_step_N,
// NNNNNN_statics_N and NNNNNN_at_rest. A folder is written under another name and renamed, so that it is
// whole or not there. The last three are kept, and the one at rest.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "coupler/checkpoint/manifest.hpp"
#include "coupler/participants/participant.hpp"
#include "protocol/state/archive.hpp"

namespace adit::coupler {

// A checkpoint whose states were read through and are whole.
struct Checkpoint {
  std::filesystem::path folder;
  Manifest manifest;
};

// That of the folder, or the newest one of a folder of results; `at_rest`: the one from which time begins.
// One that is damaged is passed over with a warning. Throws protocol::UserError where there is none, or where
// it is of another release.
Checkpoint read_checkpoint(const std::filesystem::path& folder, bool at_rest = false);

class Checkpoints {
 public:
  // `interval`: wall-clock time between two of them; none: they are not asked for.
  Checkpoints(const std::filesystem::path& results, std::optional<std::chrono::duration<double>> interval);

  bool asked_for() const { return interval_.has_value(); }
  bool any() const;  // lies there, from which the run can go on
  bool due() const { return interval_ && Clock::now() - last_ >= *interval_; }
  double seconds() const { return seconds_; }  // that the last one took
  // Writes the states of all participants and those of the coupler, by name. `manifest` says the rest.
  void write(const std::string& name, Manifest manifest, std::vector<Participant>& participants,
             const std::map<std::string, state::Parts>& of_coupler);

 private:
  using Clock = std::chrono::steady_clock;
  std::filesystem::path folder_;
  std::optional<std::chrono::duration<double>> interval_;
  Clock::time_point last_ = Clock::now();
  double seconds_ = 0;
};

}  // namespace adit::coupler

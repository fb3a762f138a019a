// A whole run, from the scene and its participants to the results in a directory.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "coupler/checkpoint/checkpoints.hpp"
#include "coupler/output/run_summary.hpp"
#include "coupler/participants/participant.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::coupler {

// Where a run goes on: with the results that lie in its directory, or, from a state at rest, with results of
// its own.
struct From {
  Checkpoint checkpoint;
  bool same_run;
};

// Runs the scene to its end, or until an error or a signal, with results in `directory`, which must exist.
// After an error the results so far stay there, with a summary that says `"completed": false` and why. Shows
// progress and prints the main figures at the end.
void run(const scene::Scene& scene, std::vector<Participant> participants, const RunLabels& labels,
         const std::filesystem::path& directory, std::optional<From> from = std::nullopt);

}  // namespace adit::coupler

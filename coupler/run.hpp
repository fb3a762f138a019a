// A whole run, from the scene and its participants to the results in a directory.
#pragma once

#include <filesystem>
#include <vector>

#include "coupler/output/run_summary.hpp"
#include "coupler/participants/participant.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::coupler {

// Runs the scene to its end, or until an error, with results in `directory`, which must exist. After an error
// the results so far stay there, with a summary that says `"completed": false` and why. Shows progress and
// prints the main figures at the end.
void run(const scene::Scene& scene, std::vector<Participant> participants, const RunLabels& labels,
         const std::filesystem::path& directory);

}  // namespace adit::coupler

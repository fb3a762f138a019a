// A whole run: from the scene and its participants to the results in a directory.
#pragma once

#include <filesystem>
#include <vector>

#include "coupler/output/run_summary.hpp"
#include "coupler/participants/participant.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::coupler {

// Runs to the end into `directory`, which exists, or until an error: then what was computed so far stays in
// the directory, with a summary that says `"completed": false` and why. Shows progress, ends with what the
// results say.
void run(const scene::Scene& scene, std::vector<Participant> participants, const RunLabels& labels,
         const std::filesystem::path& directory);

// Takes the participants through all of the set-up and ends there; throws what run() would throw.
void check(const scene::Scene& scene, std::vector<Participant> participants);

}  // namespace adit::coupler

// What a scene will compute, told before it runs: counts, time step, memory, disk, the time to expect.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "coupler/participants/participant.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::coupler {

// Sets the participants up, times about a second of steps, and prints a report; throws whatever run() would
// throw until its first step. With a `directory` that is not empty, the undeformed model goes there as the
// fields of a run do, beside `scene_yaml`; nothing is written without one. Throws protocol::UserError where
// the directory holds the results of a run.
void check(const scene::Scene& scene, std::vector<Participant> participants, const std::string& scene_yaml,
           const std::filesystem::path& directory);

}  // namespace adit::coupler

// The tables of a run's directory, but for the summary.
#pragma once

#include <filesystem>

#include "protocol/messages/scene.pb.h"
#include "simplified/output/response.hpp"

namespace adit::simplified {

// histories.csv, envelopes.csv, joints.csv, soil_profile.csv, time_distance.csv: those for which there is
// something.
void write_tables(const std::filesystem::path& directory, const scene::Simplified& scene,
                  const Response& response);

}  // namespace adit::simplified

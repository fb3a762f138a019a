// The tables in a run's directory.
#pragma once

#include <filesystem>

#include "protocol/messages/scene.pb.h"
#include "protocol/motion/motion.hpp"
#include "simplified/output/response.hpp"

namespace adit::simplified {

// Writes histories.csv, envelopes.csv, joints.csv, soil_profile.csv and time_distance.csv, as far as the
// model has such results.
void write_tables(const std::filesystem::path& directory, const scene::Simplified& scene,
                  const Response& response);

// Writes motion.csv: the acceleration that the scene gives, during the run.
void write_motion(const std::filesystem::path& directory, const motion::Motion& motion);

}  // namespace adit::simplified

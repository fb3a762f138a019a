// The scene's earthquake (ground_motion.proto).
#pragma once

#include <string>

#include "protocol/messages/ground_motion.pb.h"
#include "protocol/motion/motion.hpp"
#include "protocol/motion/synthesis/pulses.hpp"

namespace adit::motion {

// The motion as the scene prepares it: tapered, filtered, its baseline corrected, scaled. Records travel with
// the scene (attached_files.hpp). Throws UserError below `path`, such as for a record that is shorter than
// the sampling's duration.
Motion ground_motion(const scene::GroundMotion& scene, const std::string& path, const Sampling& sampling);

// For solvers whose step is much shorter: the record's own step, 1/200 of a pulse's period, 5 ms of a
// synthetic motion. Straight lines between such values lose less than 1e-4 of the amplitude of a pulse.
Motion ground_motion(const scene::GroundMotion& scene, const std::string& path, double duration);

}  // namespace adit::motion

// The ground motion of a scene (ground_motion.proto).
#pragma once

#include <string>

#include "protocol/messages/ground_motion.pb.h"
#include "protocol/motion/motion.hpp"
#include "protocol/motion/synthesis/pulses.hpp"

namespace adit::motion {

// The motion after the processing that the scene asks for: taper, filter, baseline correction, scaling.
// Records are sent with the scene (attached_files.hpp). Throws UserError below `path`, for example if a
// record is shorter than the sampling's duration.
Motion ground_motion(const scene::GroundMotion& scene, const std::string& path, const Sampling& sampling);

// The same at a step for solvers whose own step is much shorter: the step of a record, 1/200 of the period of
// a pulse, 5 ms for a synthetic motion. Straight lines between such values change the amplitude of a pulse by
// less than 1e-4.
Motion ground_motion(const scene::GroundMotion& scene, const std::string& path, double duration);

}  // namespace adit::motion

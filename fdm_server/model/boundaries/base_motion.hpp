// What a base does over time.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fdm_server/solver/loads.hpp"
#include "protocol/messages/scene.pb.h"
#include "protocol/motion/excitation/ground_motion.hpp"

namespace adit::fdm {

inline const std::string kBasePath = "continuum.base";  // in the scene

// The base's `acceleration` for a run of this duration [s]; no values if it moves in another way. UserError
// with the scene's path, such as for a record that is shorter.
motion::UsedMotion base_acceleration(const scene::Base& base, double duration);

// Velocity [m/s], or stress [Pa], of the base at any time: one for each of the ascending places [m], or one
// for all of them. UserError with the scene's path.
std::vector<TimeFactor> base_histories(const scene::Base& base, std::span<const double> places,
                                       const motion::UsedMotion& acceleration);

}  // namespace adit::fdm

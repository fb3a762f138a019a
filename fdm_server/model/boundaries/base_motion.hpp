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

// Along the base's direction and across it; no values where it does not move so, or moves in another way.
struct BaseAccelerations {
  motion::UsedMotion along, across;
};

// The base's `acceleration` and `across` for a run of this duration [s]. UserError with the scene's path,
// such as for a record that is shorter.
BaseAccelerations base_accelerations(const scene::Base& base, double duration);

// Velocity [m/s], or stress [Pa], of the base at any time: one for each of the ascending places [m], or one
// for all of them. UserError with the scene's path.
std::vector<TimeFactor> base_histories(const scene::Base& base, std::span<const double> places,
                                       const motion::UsedMotion& acceleration);

}  // namespace adit::fdm

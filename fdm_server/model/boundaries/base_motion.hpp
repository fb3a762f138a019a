// What a base does over time.
#pragma once

#include <span>
#include <vector>

#include "fdm_server/solver/loads.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

// Velocity [m/s], or stress [Pa], of the base at any time: one for each of the ascending places [m], or one
// for all of them. UserError with the scene's path, such as for a record shorter than `duration` [s].
std::vector<TimeFactor> base_histories(const scene::Base& base, std::span<const double> places,
                                       double duration);

}  // namespace adit::fdm

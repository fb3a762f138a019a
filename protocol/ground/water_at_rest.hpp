// Water at rest: its pressure grows with the depth below its level.
#pragma once

#include <algorithm>

#include "protocol/ground/stated_stress.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::protocol {

// At the height y, of water that stands up to `level` [m]; 0 above it [Pa].
inline double pressure_at_rest(const scene::Water& water, double level, double y) {
  return std::max(0.0, water.density() * kStandardGravity * (level - y));
}

}  // namespace adit::protocol

// Springs between discs: those of the scene and the bolts of a ring.
#pragma once

#include "dem_server/model/model.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

// The bolts are named bolt_0, bolt_1 … by their joints. UserError for springs that find one disc at both ends
// or none within its diameter, and for those whose force is not stated once.
std::vector<Spring> read_springs(const scene::Particles& particles, const Discs& discs);

}  // namespace adit::dem

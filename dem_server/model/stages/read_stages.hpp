// Which discs are there in each stage of excavation, and to which group they belong.
//
// A disc belongs to the last group that selects it, of those whose stage has begun. It vanishes with the
// stage of its excavation, and comes back with a later group: one that begins with that stage or after it.
#pragma once

#include <vector>

#include "dem_server/model/model.hpp"
#include "dem_server/model/placement/placement.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

// Stage 0, then each stage with which excavations, groups, joints or springs begin, or what an excavation has
// held is let go; without masses and bonds. UserError for stages in a scene without statics, and for
// excavations that leave no particle.
std::vector<ParticleStage> read_stages(const scene::Scene& scene, const Placement& placement);

}  // namespace adit::dem

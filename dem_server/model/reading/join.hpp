// Which discs of the model are joined, and by what.
#pragma once

#include "dem_server/model/model.hpp"
#include "dem_server/model/placement/groups.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

// Sets the bonds of each stage, and the laws of the model, from its discs and their groups. The rule for two
// discs near each other: the last of `joints` whose line parts them; else the ring's joints; else `between`
// their groups; else the bonds of their groups. A joint without a stage begins with the first groups between
// which it stands. UserError for joints that part nothing, groups that are unknown or joined by laws of two
// kinds.
void join(const scene::Particles& particles, const std::vector<Group>& groups,
          std::vector<ParticleStage>& stages, Model& model);

}  // namespace adit::dem

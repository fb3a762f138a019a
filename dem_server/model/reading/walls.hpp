// The rigid walls of a scene.
#pragma once

#include "dem_server/model/model.hpp"
#include "dem_server/model/placement/groups.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

// Contacts that a wall leaves out are those of the model's own group. UserError for walls without length, two
// of one name.
std::vector<MovingWall> read_walls(const scene::Particles& particles, const Group& own);

// UserError for a wall that a particle touches before anything moves: walls start free of force, and under an
// initial stress they would yield at once.
void refuse_walls_that_bear(const Model& model);

}  // namespace adit::dem

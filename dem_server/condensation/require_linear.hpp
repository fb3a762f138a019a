// What particles must be for them to wait, condensed, until something comes near its strength.
#pragma once

#include "dem_server/model/model.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

// Throws protocol::UserError at `particles.begin` for a model that is not linear until then: one of discs,
// one that nothing can break, or one with loads that change, walls, bars and the like.
void require_linear(const Model& model);

}  // namespace adit::dem

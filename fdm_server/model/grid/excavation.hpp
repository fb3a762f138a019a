// The zones that are not there from the beginning on. Errors: UserError with the scene's path.
#pragma once

#include "fdm_server/grid/grid.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

// Removes the zones of excavations of stage 0, but for those whose places materials of a later stage fill
// (zone_stages.hpp); what they lay bare is the grid's boundary.
void leave_out(const scene::Continuum& scene, Grid& grid);

}  // namespace adit::fdm

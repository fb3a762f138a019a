// From the scene to the grid.
#pragma once

#include "fdm_server/grid/grid.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

// Without the zones that are excavated in stage 0. UserError with the field's path for what makes no grid:
// values out of range, blocks that do not match, too many grid points.
Grid read_grid(const scene::Continuum& scene);

}  // namespace adit::fdm

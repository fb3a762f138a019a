// The scene's linings and bolts on the grid.
// Errors: UserError with the scene's path where a lining lies on no edges, two lie on the same, a joint lies
// off its lining, or a section or stiffness is impossible.
#pragma once

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/supports/supports.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

Supports resolve_supports(const scene::Scene& scene, const Grid& grid);

}  // namespace adit::fdm

// The scene's prescribed motions on what is left of the grid.
#pragma once

#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/solver/loads.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

// UserError for displacements, and stages of them, in a scene without statics, which alone impose them.
void require_statics_for_motions(const scene::Scene& scene);

// Errors: UserError with the scene's path, such as for a component of a point that two motions prescribe
// differently.
std::vector<PrescribedMotion> resolve_motions(const scene::Continuum& scene, const Grid& grid);

}  // namespace adit::fdm

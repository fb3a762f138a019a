// The scene's foundations on what is left of the grid. Errors: UserError with the scene's path.
#pragma once

#include <span>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "protocol/foundation/springs.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

// A quarter of the weighted area of each held zone acts on each of its points. Its springs stay, so that
// zones must not change in later stages (grid/zone_stages.hpp).
std::vector<foundation::Springs> resolve_foundations(const scene::Continuum& scene, const Grid& grid,
                                                     std::span<const double> weights);

}  // namespace adit::fdm

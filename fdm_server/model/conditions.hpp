// The scene's loads on what is left of the grid.
// Errors: UserError with the scene's path.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fdm_server/boundaries/free_field.hpp"
#include "fdm_server/grid/grid.hpp"
#include "fdm_server/solver/loads.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

// Point loads in equal shares; edge loads by length over edges on the grid's boundary (an edge that appears
// where zones vanished is no boundary of the body), half of an edge's share to each end; body loads on the
// weighted masses of the points. Point and edge loads are not weighted: they are total forces. Free-field
// columns are loaded as their sides are: by body loads, and by the tractions of edges that meet their ends.
std::vector<Load> resolve_loads(const scene::Continuum& scene, const Grid& grid,
                                std::span<const double> masses, std::span<const FreeFieldColumn> columns);

}  // namespace adit::fdm

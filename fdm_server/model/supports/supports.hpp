// The scene's linings, bolts and interfaces on the grid.
// Errors: UserError with the scene's path where a lining lies on no edges, two lie on the same, a joint lies
// off its lining, a section or stiffness is impossible, or an interface has no zones to join.
#pragma once

#include <span>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/materials/material.hpp"
#include "fdm_server/supports/supports.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

// Cuts the grid along the interfaces, and gives linings that have one points of their own. `weights`: of the
// zones; none: all 1.
Supports resolve_supports(const scene::Scene& scene, const Ground& ground, std::span<const double> weights,
                          Grid& grid);

}  // namespace adit::fdm

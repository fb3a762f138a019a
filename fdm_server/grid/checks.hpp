// Is a grid fit to be computed?
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "fdm_server/grid/grid.hpp"

namespace adit::fdm {

// How the user knows a zone: "zone 3 of blocks[1]", "element 17".
using ZoneName = std::function<std::string(std::uint32_t zone)>;

// Throws UserError at `path` for the first
// - tangled zone: one whose Jacobian is not positive at each corner (at least 1e-9 of its largest diagonal
//   squared), so that it is not convex, or has no area;
// - two zones on the same side of an edge (a zone given twice, or three at one edge);
// - point of the boundary that lies in a zone which is not its own, to a thousandth of the zone: two points
// at one
//   place (which keep the grid from being joined), a point on another zone's side (hanging), an overlap;
// - zone that no way through shared edges leads to.
void require_sound(const Grid& grid, const std::string& path, const ZoneName& name_of);

}  // namespace adit::fdm

// Cuts a grid along sides of zones, so that the zones on either side of a cut no longer share points.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "fdm_server/grid/grid.hpp"

namespace adit::fdm {

using Side = std::array<std::uint32_t, 2>;  // of zones: two points

// At each point on a cut the zones that the cuts leave together keep a point together; the first of them the
// point itself, the others one of their own at the same place, which is added to the grid. So an end of a cut
// inside the grid stays joined, and cuts may meet and cross. Points that are `kept` stay whole. Before zones
// with corners of their own are added.
void cut(Grid& grid, std::span<const Side> sides, const std::vector<bool>& kept);

// The same zones with their points as they were before.
Grid welded(Grid grid);

}  // namespace adit::fdm

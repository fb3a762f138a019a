// What an area of the scene selects of the grid, within `tolerance` of it.
// Errors: UserError at `path` where it selects nothing, or names a group that the grid does not have.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "protocol/messages/geometry.pb.h"

namespace adit::fdm {

// Ascending. Of a group: the points of its zones and edges.
std::vector<std::uint32_t> select_points(const Grid& grid, const scene::Area& area, const std::string& path);

// Zones whose centroids the area holds, ascending; with zones_in() there may be none.
std::vector<std::uint32_t> zones_in(const Grid& grid, const scene::Area& area, const std::string& path);
std::vector<std::uint32_t> select_zones(const Grid& grid, const scene::Area& area, const std::string& path);

// Edges of the grid's boundary whose two ends the area holds. Of a group: its own edges, or the sides of its
// zones on the grid's boundary where it has none.
std::vector<Edge> select_edges(const Grid& grid, const scene::Area& area, const std::string& path);

}  // namespace adit::fdm

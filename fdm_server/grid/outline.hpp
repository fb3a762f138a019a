// The boundary of the body: what surrounds the original grid, not what appears where zones vanished.
#pragma once

#include <cstdint>
#include <vector>

#include "fdm_server/grid/grid.hpp"

namespace adit::fdm {

// One side of a zone; the body lies left of it, on the way from its first point to its second.
struct BoundaryEdge {
  std::uint32_t from, to, zone;
  double length;              // [m]
  double normal_x, normal_y;  // outwards
};

// Edges whose two ends lie on the same side of the block.
std::vector<BoundaryEdge> outline(const Block& block, const Grid& grid);

}  // namespace adit::fdm

// An edge of the grid's boundary with its measures.
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

std::vector<BoundaryEdge> outline(const Grid& grid);

}  // namespace adit::fdm

// The parts of lines that areas leave free.
#pragma once

#include <vector>

#include "dem_server/packing/voronoi/cell_points.hpp"
#include "protocol/geometry/selection.hpp"

namespace adit::dem {

struct Cover {
  protocol::Places inside;         // without the boundary
  std::vector<CellFace> outlines;  // the boundary
};

// The line without what lies inside one of the covers, whose outlines it meets within `reach` [m]; what runs
// along an outline is kept. A closed line that nothing covers stays closed.
std::vector<FaceLine> uncovered(const FaceLine& line, const std::vector<Cover>& covers, double reach);

}  // namespace adit::dem

// Nuclei beside the faces: where consecutive discs of a face's cover cut each other.
#pragma once

#include <vector>

#include "dem_server/packing/voronoi/cover_discs.hpp"
#include "dem_server/packing/voronoi/margin.hpp"
#include "dem_server/packing/voronoi/point_grid.hpp"

namespace adit::dem {

// Adds the nuclei of the faces, in their order, as far as they lie not in the margin, in no other disc of
// their own face or of an earlier one, and not too close to others. Returns the discs between which no
// nucleus is missing: the faces are edges of cells if these stay free of further nuclei.
std::vector<DiscField> add_face_nuclei(const std::vector<FaceCover>& covers, const Margin& margin,
                                       PointGrid& nuclei);

}  // namespace adit::dem

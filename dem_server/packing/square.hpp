// Square packing of equal discs in a box: columns above columns, each disc touching four.
#pragma once

#include "dem_server/packing/discs.hpp"
#include "protocol/geometry/bounding_box.hpp"

namespace adit::dem {

// As many columns and rows 2 R wide as fit, centred in the box; row by row from below, each from left to
// right.
Discs pack_squarely(const geometry::BoundingBox& box, double radius);

}  // namespace adit::dem

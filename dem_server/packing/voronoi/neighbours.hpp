// Which points have cells of Voronoi that touch.
#pragma once

#include <span>
#include <vector>

#include "dem_server/packing/discs.hpp"
#include "protocol/geometry/shape.hpp"

namespace adit::dem {

// All pairs of points whose cells share a facet, each pair once, ascending; and some whose cells meet in a
// corner only or nearly meet, so that whoever cuts the cells finds every facet in spite of rounding. The
// points lie in the box. Throws std::invalid_argument where two coincide within 2^-30 of the box's extent.
std::vector<Pair> neighbours_in_diagram(std::span<const geometry::Point> points,
                                        const geometry::BoundingBox& box);

}  // namespace adit::dem

// Where the discs of a model are.
#pragma once

#include "dem_server/packing/discs.hpp"
#include "protocol/geometry/bounding_box.hpp"

namespace adit::dem {

// The box around at least one disc.
geometry::BoundingBox extent_of(const Discs& discs);

}  // namespace adit::dem

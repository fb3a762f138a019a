// Where the discs of a model are.
#pragma once

#include "dem_server/packing/discs.hpp"
#include "dem_server/packing/hexagonal.hpp"

namespace adit::dem {

// The box around at least one disc.
Rectangle extent_of(const Discs& discs);

}  // namespace adit::dem

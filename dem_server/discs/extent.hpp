// Where the discs of a model are.
#pragma once

#include "dem_server/packing/discs.hpp"
#include "dem_server/packing/hexagonal.hpp"

namespace adit::dem {

// The box around at least one disc.
Rectangle extent_of(const Discs& discs);

// UserError where two discs have the same centre: no normal leads from one to the other.
void refuse_coincident(const Discs& discs);

}  // namespace adit::dem

// The springs of a bond.
#pragma once

#include "dem_server/model/model.hpp"

namespace adit::dem {

// While it is whole, with the contact beside it.
BondSprings whole_springs(const Model& model, const Bond& bond);

// The stiffest ones that it has in any state: whole or broken.
BondSprings stiffest_springs(const Model& model, const Bond& bond);

}  // namespace adit::dem

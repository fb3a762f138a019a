// The springs of a bond.
#pragma once

#include "dem_server/model/model.hpp"

namespace adit::dem {

struct BondSprings {
  double kn = 0, ks = 0, km = 0;  // [N/m], [N/m], [N m]
};

// While it is whole, with the contact beside it.
BondSprings whole_springs(const Model& model, const Bond& bond);

// The stiffest ones that it has in any state: whole or broken.
BondSprings stiffest_springs(const Model& model, const Bond& bond);

}  // namespace adit::dem

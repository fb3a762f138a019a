// The stiffest springs that a bond has in any state: whole, with the contact beside it, or broken.
#pragma once

#include "dem_server/model/model.hpp"

namespace adit::dem {

struct BondSprings {
  double kn = 0, ks = 0, km = 0;  // [N/m], [N/m], [N m]
};

BondSprings stiffest_springs(const Model& model, const Bond& bond);

}  // namespace adit::dem

// The springs of a bond, and whether it can break.
#pragma once

#include <cstddef>

#include "dem_server/model/model.hpp"

namespace adit::dem {

// While it is whole, with the contact beside it.
BondSprings whole_springs(const Model& model, const Bond& bond);

// The stiffest ones that it has in any state: whole or broken. `contact`: that of its discs, which acts
// beside a parallel bond and in place of a broken one.
BondSprings stiffest_springs(const Model& model, const Bond& bond);
BondSprings stiffest_springs(const Model& model, const Bond& bond, const LinearContact& contact);

// Whether it has a finite strength, in tension or in shear. A smooth joint has none.
bool is_breakable(const Model& model, const Bond& bond);
std::size_t breakable_bonds(const Model& model);  // in the stage that has most of them

// The contact of the bond's discs.
const LinearContact& contact_of(const Model& model, const Bond& bond);

}  // namespace adit::dem

#pragma once

#include <cstddef>

#include "dem_server/model/model.hpp"

namespace adit::dem {

// Number of the bonds that have a finite strength, in tension or in shear. A smooth joint has none.
std::size_t breakable_bonds(const Model& model);

}  // namespace adit::dem

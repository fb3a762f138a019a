// Where a model needs the energy weights of an overlap.
#pragma once

#include <vector>

#include "dem_server/model/model.hpp"

namespace adit::dem {

// The discs' centres, then the bonds' midpoints, where the discs meet; x0 y0 x1 y1 … [m]
std::vector<double> sample_points(const Model& model);

}  // namespace adit::dem

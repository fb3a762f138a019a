// What of a model exists under the energy weights of an overlap.
#pragma once

#include <span>

#include "dem_server/model/model.hpp"

namespace adit::dem {

// Energy weights at the discs' centres and the bonds' midpoints, in the model's order.
struct SampledWeights {
  std::span<const double> centres, midpoints;
  double floor;  // smallest weight of what exists
};

// A disc whose centre has weight 0 vanishes with all that hangs on it; every other bond keeps its midpoint's
// weight, at least the floor. A disc's weight is the mean of its bonds', by stiffness (of its centre, where
// it has none), so that the weights cannot shorten the critical step: where every bond has the share of its
// discs' masses that its stiffness has, it finds at least its weight times its share of the whole model.
//
// protocol::UserError at a load or motion of which no disc is left, unless the whole model vanishes: then it
// is returned empty.
Model weigh(const Model& whole, const SampledWeights& weights);

}  // namespace adit::dem

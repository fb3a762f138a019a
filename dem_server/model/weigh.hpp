// What of a model exists under the energy weights of an overlap.
#pragma once

#include <cstdint>
#include <vector>

#include "dem_server/engines/general/solver.hpp"
#include "dem_server/model/model.hpp"
#include "dem_server/particles/assembly.hpp"

namespace adit::dem {

struct Weighed {
  Model model;
  ModelWeights weights;
  std::vector<std::uint32_t> id;  // of each disc: its place in the packing
};

// A disc whose centre has weight 0 vanishes with all that hangs on it; every other joined pair keeps its
// midpoint's weight, at least the floor. A disc's weight is the mean of its pairs', by stiffness (of its
// centre, where it has none), so that the weights cannot shorten the critical step: with shares of mass as in
// critical_step.hpp every pair finds at least its weight times its share of the whole model. Midpoints in the
// order of model.joined.
Weighed weigh(const Weighed& whole, const SampledWeights& weights);

}  // namespace adit::dem

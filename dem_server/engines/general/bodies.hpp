// The solver's arrays from a model.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/engines/general/forces/joints.hpp"
#include "dem_server/engines/general/pairs.hpp"
#include "dem_server/model/model.hpp"

namespace adit::dem {

// At rest; weights of the discs, 1 where empty.
Particles particles_of(const Model& model, std::span<const double> weights);

struct Bonded {
  std::vector<PairLaw> laws;  // of the bonds, then of the contacts of all pairs of groups
  std::uint32_t first_contact_law = 0;
  Pairs bonds;
  std::vector<std::uint32_t> joined_of_bond;  // in model.joined
  std::vector<Joints::Joint> joints;
  bool dashpots = false;  // some contact of discs has
};
// Weights of model.joined, 1 where empty.
Bonded bonds_of(const Model& model, std::span<const double> weights);

}  // namespace adit::dem

// The solver's pairs and joints from a model.
#pragma once

#include <cstdint>
#include <vector>

#include "dem_server/engines/general/forces/joints.hpp"
#include "dem_server/engines/general/pairs/pairs.hpp"
#include "dem_server/model/model.hpp"

namespace adit::dem {

struct Bonded {
  std::vector<PairLaw> laws;  // of the bonds, then of the contacts of all pairs of groups
  std::uint32_t first_contact_law = 0;
  Pairs bonds;
  std::vector<std::uint32_t> bond_of_pair;  // in model.bonds
  std::vector<Joints::Joint> joints;
  bool dashpots = false;  // some contact of discs has
};
Bonded bonds_of(const Model& model);

// The discs that bonds join.
std::vector<Pair> pairs_of(const std::vector<Bond>& bonds);

}  // namespace adit::dem

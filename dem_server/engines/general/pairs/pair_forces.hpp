// Forces of pairs of discs, block by block (laws: pairs.hpp).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/engines/general/pairs/pairs.hpp"

namespace adit::dem {

// A block's pairs in one step; sums over blocks are taken in their order.
struct PairResult {
  double max_normal_force = 0;        // largest |N|, unweighted [N]; not finite where any is not
  std::uint32_t strongest = 0;        // the first pair that carries it
  double friction = 0, dashpots = 0;  // dissipated in this step, weighted [J]
  double released = 0;                // stored in the bonds that broke, weighted [J]
  std::vector<std::uint32_t> broken;  // pairs, ascending
};

// Adds the forces of a block's pairs to the discs of the block, and those on other discs to `away`. `dt` is 0
// where the step starts from rest: nothing slips then. Resets `result`.
void add_pair_forces(std::uint32_t block, std::span<const PairLaw> laws, double dt, Particles& particles,
                     Pairs& pairs, PairResult& result);

// Adds to the discs of a block what pairs of other blocks do to them.
void gather_pair_forces(std::uint32_t block, const Pairs& pairs, Particles& particles);

}  // namespace adit::dem

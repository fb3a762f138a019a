// Forces of pairs of discs, block by block (laws: pairs.hpp).
#pragma once

#include <cstdint>
#include <span>

#include "dem_server/engines/general/pairs/block_discs.hpp"
#include "dem_server/engines/general/pairs/chunk.hpp"

namespace adit::dem {

// Adds the forces of a block's pairs to the sums of `of_block`, which has taken the block, and puts those on
// discs of other blocks into `away`. `dt` is 0 where the step starts from rest: nothing slips then. With
// `relax` internal forces are summed, too. Resets `result`.
void add_pair_forces(std::uint32_t block, std::span<const PairLaw> laws, double dt, bool relax,
                     const Particles& particles, Pairs& pairs, BlockDiscs& of_block, PairResult& result);

// Adds to the discs of a block what pairs of other blocks do to them.
void gather_pair_forces(std::uint32_t block, const Pairs& pairs, Particles& particles);

}  // namespace adit::dem

// Forces of pairs of discs: the kernel of the solver (laws: pairs.hpp).
//
// n is the unit vector from the first to the second centre now, t its left normal; they meet in the middle of
// their gap, arm_1 = L / 2 + (r1 - r2) / 2 and arm_2 = L - arm_1 away. Pull, moments and signs as in
// laws/encounter.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/engines/general/pairs.hpp"
#include "dem_server/laws/encounter.hpp"

namespace adit::dem {

// Of a block's pairs in one step; sums over blocks are taken in their order.
struct PullResult {
  double max_normal_force = 0;        // largest |N|, unweighted [N]; not finite where any is not
  std::uint32_t strongest = 0;        // the first pair that carries it
  double friction = 0, dashpots = 0;  // dissipated in this step, weighted [J]
  double released = 0;                // stored in the cement that broke, weighted [J]
  std::vector<std::uint32_t> broken;  // pairs, ascending
};

// Adds the forces of a block's pairs to the discs of the block, and those on other discs to `away`. `dt` is 0
// where the step starts from rest: nothing slips then. Resets `result`.
void pull_block(std::uint32_t block, std::span<const PairLaw> laws, double dt, Particles& particles,
                Pairs& pairs, PullResult& result);

// Adds to the discs of a block what pairs of other blocks do to them.
void gather_block(std::uint32_t block, const Pairs& pairs, Particles& particles);

}  // namespace adit::dem

// What happens where a bond of a pair exceeds a strength.
#pragma once

#include <cstdint>

#include "dem_server/engines/general/pairs/chunk.hpp"

namespace adit::dem {

// Breaks the bond of a pair, number k of its chunk, where it exceeds a strength: its forces become those of
// the contact that is left, and what the bond gave up is added to `released`, weighted [J]. Returns whether
// it broke.
bool break_bond(const PairLaw& law, std::uint32_t pair, std::uint32_t k, double dt, const ChunkDiscs& discs,
                Pairs& pairs, ChunkForces& forces, double& released);

}  // namespace adit::dem

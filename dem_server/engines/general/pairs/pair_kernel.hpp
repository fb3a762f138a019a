// The laws of a chunk's pairs in vector code.
#pragma once

#include <cstdint>

#include "dem_server/engines/general/pairs/chunk.hpp"

namespace adit::dem {

struct ChunkOutcome {
  std::int64_t max_bits;  // of |N|: the order of non-negative doubles is that of their bits, NaN above all
  bool breaks, slides;    // some bond exceeds a strength, some contact slides
};

// Forces of a chunk's pairs; the pairs' spring and dashpot forces become those after the step.
// `dashpots`: act in its contacts.
ChunkOutcome find_forces(const Pairs::Chunk& chunk, double dt, const ChunkDiscs& discs, const ChunkLaws& laws,
                         bool dashpots, Pairs& pairs, ChunkForces& out);

}  // namespace adit::dem

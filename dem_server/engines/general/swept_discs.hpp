// Which discs a block of pairs completes. Nothing but pairs of their own block pulls on most discs: they are
// swept, that is accounted and kicked as soon as the block has its forces, while it is in the cache. The
// others are kept until all that pulls on them has been added.
#pragma once

#include <cstdint>
#include <vector>

#include "protocol/threads/index_ranges.hpp"

namespace adit::dem {

struct SweptDiscs {
  std::vector<std::uint8_t> swept;                      // of each disc: 1, or 0 where it is kept
  std::vector<std::vector<protocol::IndexRange>> kept;  // of each block

  SweptDiscs() = default;
  explicit SweptDiscs(const std::vector<bool>& keep);
};

}  // namespace adit::dem

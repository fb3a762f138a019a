// Bodies of discs: what whole bonds hold together; and how many neighbours a disc has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/packing/discs.hpp"

namespace adit::dem {

struct Fragments {
  std::vector<std::uint32_t>
      number;                       // of each disc: its fragment, from 0, in the order of their lowest discs
  std::vector<std::uint32_t> size;  // of each fragment: its discs
  std::size_t count() const { return size.size(); }
};

// Discs that a chain of `holding` pairs joins are one fragment; a disc that nothing holds is one by itself.
Fragments fragments_of(std::size_t discs, std::span<const Pair> holding);

struct HoldingPair {
  Pair pair;
  bool resists_turning;
};
// The pairs that are left when discs which hang on a single pair have been taken away, one after the other:
// such a disc rolls on its neighbour, unless the pair resists turning.
std::vector<Pair> without_rolling(std::size_t discs, std::span<const HoldingPair> holding);

// The number of pairs that each disc is part of.
std::vector<std::uint32_t> coordination_of(std::size_t discs, std::span<const Pair> touching);

}  // namespace adit::dem

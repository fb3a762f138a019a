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

// The number of pairs that each disc is part of.
std::vector<std::uint32_t> coordination_of(std::size_t discs, std::span<const Pair> touching);

}  // namespace adit::dem

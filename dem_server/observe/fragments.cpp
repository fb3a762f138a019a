#include "dem_server/observe/fragments.hpp"

#include <algorithm>
#include <numeric>

namespace adit::dem {

// Trees of discs, whose roots are their lowest discs: two trees become one where a pair joins them, and ways
// to the root are halved as they are gone (Tarjan & van Leeuwen 1984, J. ACM 31, 245).
Fragments fragments_of(std::size_t discs, std::span<const Pair> holding) {
  std::vector<std::uint32_t> above(discs);
  std::iota(above.begin(), above.end(), 0u);
  const auto root_of = [&above](std::uint32_t i) {
    while (above[i] != i) i = above[i] = above[above[i]];
    return i;
  };
  for (const Pair& pair : holding) {
    const auto [low, high] = std::minmax({root_of(pair.first), root_of(pair.second)});
    above[high] = low;
  }
  Fragments fragments;
  fragments.number.resize(discs);
  for (std::uint32_t i = 0; i < discs; ++i) {
    const std::uint32_t root = root_of(i);
    if (root == i) {
      fragments.number[i] = static_cast<std::uint32_t>(fragments.count());
      fragments.size.push_back(0);
    }
    fragments.number[i] = fragments.number[root];
    ++fragments.size[fragments.number[i]];
  }
  return fragments;
}

std::vector<std::uint32_t> coordination_of(std::size_t discs, std::span<const Pair> touching) {
  std::vector<std::uint32_t> count(discs, 0);
  for (const Pair& pair : touching)
    for (const std::uint32_t i : {pair.first, pair.second}) ++count[i];
  return count;
}

}  // namespace adit::dem

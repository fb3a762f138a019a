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

std::vector<Pair> without_rolling(std::size_t discs, std::span<const HoldingPair> holding) {
  std::vector<std::uint32_t> supports(discs, 0);  // a pair that resists turning is as good as two
  std::vector<std::vector<std::uint32_t>> pairs_of(discs);
  for (std::uint32_t k = 0; k < holding.size(); ++k)
    for (const std::uint32_t i : {holding[k].pair.first, holding[k].pair.second}) {
      supports[i] += holding[k].resists_turning ? 2 : 1;
      pairs_of[i].push_back(k);
    }
  std::vector<std::uint32_t> rolling;
  for (std::uint32_t i = 0; i < discs; ++i)
    if (supports[i] == 1) rolling.push_back(i);
  std::vector<bool> firm(holding.size(), true);
  while (!rolling.empty()) {
    const std::uint32_t disc = rolling.back();
    rolling.pop_back();
    for (const std::uint32_t k : pairs_of[disc]) {
      if (!firm[k]) continue;
      firm[k] = false;
      const std::uint32_t other = holding[k].pair.first + holding[k].pair.second - disc;
      if (--supports[other] == 1) rolling.push_back(other);
    }
  }
  std::vector<Pair> left;
  for (std::size_t k = 0; k < holding.size(); ++k)
    if (firm[k]) left.push_back(holding[k].pair);
  return left;
}

std::vector<std::uint32_t> coordination_of(std::size_t discs, std::span<const Pair> touching) {
  std::vector<std::uint32_t> count(discs, 0);
  for (const Pair& pair : touching)
    for (const std::uint32_t i : {pair.first, pair.second}) ++count[i];
  return count;
}

}  // namespace adit::dem

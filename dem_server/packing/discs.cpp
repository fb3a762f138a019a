#include "dem_server/packing/discs.hpp"

#include <algorithm>

#include "dem_server/packing/torus.hpp"

namespace adit::dem {

std::vector<Pair> pairs_within(const Discs& discs, double reach) {
  if (discs.size() == 0) return {};
  const Torus torus(2 * std::ranges::max(discs.radius) + reach, discs.x, discs.y);
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i < discs.size(); ++i) {
    const auto begin = static_cast<std::ptrdiff_t>(pairs.size());
    torus.visit_around(i, [&](std::uint32_t j) {
      const double limit = discs.radius[i] + discs.radius[j] + reach;
      const double dx = discs.x[j] - discs.x[i], dy = discs.y[j] - discs.y[i];
      if (j > i && dx * dx + dy * dy <= limit * limit) pairs.push_back({i, j});
    });
    std::ranges::sort(pairs.begin() + begin, pairs.end(), {}, &Pair::second);
  }
  return pairs;
}

void keep_only(const std::vector<bool>& keep, Discs& discs) {
  for (auto* column : {&discs.x, &discs.y, &discs.radius}) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < keep.size(); ++i)
      if (keep[i]) (*column)[kept++] = (*column)[i];
    column->resize(kept);
  }
}

std::vector<bool> without_floaters(std::size_t discs, std::span<const Pair> contacts,
                                   std::span<const std::uint32_t> walls, std::uint32_t fewest) {
  std::vector<bool> keep(discs, true);
  for (bool changed = true; changed;) {
    std::vector<std::uint32_t> count(walls.begin(), walls.end());
    count.resize(discs, 0);
    for (const auto [i, j] : contacts)
      if (keep[i] && keep[j]) {
        ++count[i];
        ++count[j];
      }
    changed = false;
    for (std::size_t i = 0; i < discs; ++i)
      if (keep[i] && count[i] < fewest) {
        keep[i] = false;
        changed = true;
      }
  }
  return keep;
}

}  // namespace adit::dem

#include "dem_server/packing/discs.hpp"

#include <algorithm>
#include <cmath>

#include "protocol/cells.hpp"

namespace adit::dem {

std::vector<Pair> pairs_within(const Discs& discs, double reach) {
  std::vector<protocol::Extent> extents;
  extents.reserve(discs.size());
  double largest = 0;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const double r = discs.radius[i] + reach / 2;
    extents.push_back({discs.x[i] - r, discs.x[i] + r, discs.y[i] - r, discs.y[i] + r});
    largest = std::max(largest, r);
  }
  const protocol::Cells cells(extents, 2 * largest);
  std::vector<Pair> pairs;
  std::vector<std::uint32_t> near;
  for (std::uint32_t i = 0; i < discs.size(); ++i) {
    near.clear();
    cells.visit_near(discs.x[i], discs.y[i], discs.radius[i] + reach / 2, [&](std::uint32_t j) {
      const double limit = discs.radius[i] + discs.radius[j] + reach;
      const double dx = discs.x[j] - discs.x[i], dy = discs.y[j] - discs.y[i];
      if (j > i && dx * dx + dy * dy <= limit * limit) near.push_back(j);
    });
    std::ranges::sort(near);
    const auto repeated = std::ranges::unique(near);
    near.erase(repeated.begin(), repeated.end());
    for (const auto j : near) pairs.push_back({i, j});
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

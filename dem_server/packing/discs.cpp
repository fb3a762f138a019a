#include "dem_server/packing/discs.hpp"

#include <algorithm>
#include <cmath>

#include "dem_server/packing/torus.hpp"

namespace adit::dem {
namespace {

// Discs whose radii differ by less than a factor of two, in cells of their own.
struct Level {
  double largest;  // radius [m]
  std::vector<std::uint32_t> discs;
  Torus torus;
};

std::vector<Level> levels_of(const Discs& discs, double reach) {
  std::vector<std::vector<std::uint32_t>> by_size;
  const double largest = std::ranges::max(discs.radius);
  for (std::uint32_t i = 0; i < discs.size(); ++i) {
    const auto level = static_cast<std::size_t>(std::ilogb(largest / discs.radius[i]));
    if (level >= by_size.size()) by_size.resize(level + 1);
    by_size[level].push_back(i);
  }
  std::vector<Level> levels;
  for (auto& own : by_size) {
    if (own.empty()) continue;
    double radius = 0;
    std::vector<double> x, y;
    for (const std::uint32_t i : own) {
      radius = std::max(radius, discs.radius[i]);
      x.push_back(discs.x[i]);
      y.push_back(discs.y[i]);
    }
    // Cells as wide as two discs of the level and the reach: a search then looks at few cells of few discs.
    levels.push_back({radius, std::move(own), Torus(2 * radius + reach, x, y)});
  }
  return levels;
}

// By first, then by second.
std::vector<Pair> in_order(std::size_t discs, const std::vector<Pair>& pairs) {
  std::vector<std::uint32_t> starts(discs + 1, 0);
  for (const Pair& pair : pairs) ++starts[pair.first + 1];
  for (std::size_t i = 0; i < discs; ++i) starts[i + 1] += starts[i];
  std::vector<Pair> ordered(pairs.size());
  auto next = starts;
  for (const Pair& pair : pairs) ordered[next[pair.first]++] = pair;
  for (std::size_t i = 0; i < discs; ++i)
    std::ranges::sort(ordered.begin() + starts[i], ordered.begin() + starts[i + 1], {}, &Pair::second);
  return ordered;
}

}  // namespace

// A pair is found from its smaller disc, among those of its own level and of the levels above: few, however
// many small ones surround a large one.
std::vector<Pair> pairs_within(const Discs& discs, double reach) {
  if (discs.size() == 0) return {};
  const auto levels = levels_of(discs, reach);
  std::vector<Pair> pairs;
  const auto add_if_near = [&](std::uint32_t i, std::uint32_t j) {
    const double limit = discs.radius[i] + discs.radius[j] + reach;
    const double dx = discs.x[j] - discs.x[i], dy = discs.y[j] - discs.y[i];
    if (dx * dx + dy * dy <= limit * limit) pairs.push_back({std::min(i, j), std::max(i, j)});
  };
  for (std::size_t own = 0; own < levels.size(); ++own)
    for (const std::uint32_t i : levels[own].discs) {
      const double x = discs.x[i], y = discs.y[i], radius = discs.radius[i];
      for (std::size_t k = 0; k < own; ++k) {
        const Level& above = levels[k];
        above.torus.visit_near(x, y, radius + above.largest + reach,
                               [&](std::uint32_t place) { add_if_near(i, above.discs[place]); });
      }
      const Level& level = levels[own];
      level.torus.visit_onwards(
          x, y, radius + level.largest + reach,
          [&](std::uint32_t place) {
            if (i < level.discs[place]) add_if_near(i, level.discs[place]);
          },
          [&](std::uint32_t place) { add_if_near(i, level.discs[place]); });
    }
  return in_order(discs.size(), pairs);
}

std::vector<bool> without_floaters(std::size_t discs, std::span<const Pair> contacts,
                                   std::span<const std::uint32_t> walls, std::uint32_t fewest) {
  std::vector<bool> keep(discs, true);
  // A disc that goes takes contacts from its neighbours, so the count is repeated until none goes.
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

geometry::BoundingBox extent_of(const Discs& d) {
  geometry::BoundingBox box{d.x[0], d.x[0], d.y[0], d.y[0]};
  for (std::size_t i = 0; i < d.size(); ++i) {
    box.x_min = std::min(box.x_min, d.x[i] - d.radius[i]);
    box.x_max = std::max(box.x_max, d.x[i] + d.radius[i]);
    box.y_min = std::min(box.y_min, d.y[i] - d.radius[i]);
    box.y_max = std::max(box.y_max, d.y[i] + d.radius[i]);
  }
  return box;
}

}  // namespace adit::dem

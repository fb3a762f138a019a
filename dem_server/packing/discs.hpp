// Discs of any size: what a packing is before its particles are joined.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "protocol/geometry/bounding_box.hpp"

namespace adit::dem {

struct Discs {
  std::vector<double> x, y, radius;  // centre and radius [m]
  std::size_t size() const { return x.size(); }
};

// Two discs, first < second.
struct Pair {
  std::uint32_t first, second;
  bool operator==(const Pair&) const = default;
};

// Pairs whose gap, the distance of the centres less both radii, is at most `reach` [m]; ascending by first,
// then by second.
std::vector<Pair> pairs_within(const Discs& discs, double reach);

// Keeps the values for which keep[i] is set, in their order, of each of some columns.
template <class... Columns>
void keep_only(const std::vector<bool>& keep, Columns&... columns) {
  const auto thin_out = [&keep](auto& column) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < column.size(); ++i)
      if (keep[i]) column[kept++] = column[i];
    column.resize(kept);
  };
  (thin_out(columns), ...);
}
inline void keep_only(const std::vector<bool>& keep, Discs& discs) {
  keep_only(keep, discs.x, discs.y, discs.radius);
}

// Which discs hold their neighbours: those left when discs with fewer than `fewest` contacts are taken away
// until there are none. Contacts are the pairs, and `walls[i]` further ones of disc i (empty: none).
std::vector<bool> without_floaters(std::size_t discs, std::span<const Pair> contacts,
                                   std::span<const std::uint32_t> walls, std::uint32_t fewest);

// Where the discs of a model are.
// The box around at least one disc.
geometry::BoundingBox extent_of(const Discs& discs);

}  // namespace adit::dem

#include "dem_server/particles/bonded_neighbours.hpp"

#include <algorithm>

namespace adit::dem {

BondedNeighbours::BondedNeighbours(const BondEnds& bonds, std::size_t particles)
    : starts_(particles + 1, 0), higher_(bonds.size()) {
  const auto lower_of = [&](std::size_t k) { return std::min(bonds.first[k], bonds.second[k]); };
  for (std::size_t k = 0; k < bonds.size(); ++k) ++starts_[lower_of(k) + 1];
  for (std::size_t i = 0; i < particles; ++i) starts_[i + 1] += starts_[i];
  auto next = starts_;
  for (std::size_t k = 0; k < bonds.size(); ++k)
    higher_[next[lower_of(k)]++] = std::max(bonds.first[k], bonds.second[k]);
}

bool BondedNeighbours::bonded(std::uint32_t a, std::uint32_t b) const {
  return std::ranges::find(above(std::min(a, b)), std::max(a, b)) != above(std::min(a, b)).end();
}

}  // namespace adit::dem

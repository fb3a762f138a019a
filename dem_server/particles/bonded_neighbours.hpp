// Which particles are joined by a bond, whole or broken.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace adit::dem {

// The particles that bonds join.
struct BondEnds {
  std::span<const std::uint32_t> first, second;
  double longest;  // bond at rest [m]
  std::size_t size() const { return first.size(); }
};

class BondedNeighbours {
 public:
  BondedNeighbours() = default;
  BondedNeighbours(const BondEnds& bonds, std::size_t particles);

  // Those of a higher number, in the bonds' order.
  std::span<const std::uint32_t> above(std::uint32_t particle) const {
    return std::span(higher_).subspan(starts_[particle], starts_[particle + 1] - starts_[particle]);
  }
  bool bonded(std::uint32_t a, std::uint32_t b) const;

 private:
  std::vector<std::uint32_t> starts_, higher_;  // compressed rows
};

}  // namespace adit::dem

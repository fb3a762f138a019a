// Which particles are joined by a bond, whole or broken.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/particles/assembly.hpp"

namespace adit::dem {

// Bonds as pairs of particles. `longest`: of their lengths at rest [m].
struct BondedPairs {
  std::span<const std::uint32_t> first, second;
  double longest;
  BondedPairs(std::span<const std::uint32_t> first, std::span<const std::uint32_t> second, double longest)
      : first(first), second(second), longest(longest) {}
  BondedPairs(const Bonds& bonds) : BondedPairs(bonds.first, bonds.second, bonds.rest_length) {}
  std::size_t size() const { return first.size(); }
};

class Partners {
 public:
  Partners() = default;
  Partners(const BondedPairs& bonds, std::size_t particles);

  // Those of a higher number, in the bonds' order.
  std::span<const std::uint32_t> above(std::uint32_t particle) const {
    return std::span(higher_).subspan(starts_[particle], starts_[particle + 1] - starts_[particle]);
  }
  bool joined(std::uint32_t a, std::uint32_t b) const;

 private:
  std::vector<std::uint32_t> starts_, higher_;  // compressed rows
};

}  // namespace adit::dem

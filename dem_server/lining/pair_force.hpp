// The force between two particles, wherever it comes from.
#pragma once

#include <cstdint>

namespace adit::dem {

// What a pair does to its first particle; to the second it does the opposite at the same place. No energy
// weight, no dashpots.
struct PairForce {
  std::uint32_t first, second;
  double x, y, fx, fy, moment;  // place [m], force [N], moment of the bond beside it [N m]
};

}  // namespace adit::dem

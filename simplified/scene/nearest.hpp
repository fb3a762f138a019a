// The place nearest to a chainage.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace adit::simplified {

// The number of the nearest place; there is at least one, and they may stand in any order.
inline std::size_t nearest(const std::vector<double>& places, double chainage) {
  const auto closer = [chainage](double a, double b) {
    return std::abs(a - chainage) < std::abs(b - chainage);
  };
  return static_cast<std::size_t>(std::ranges::min_element(places, closer) - places.begin());
}

}  // namespace adit::simplified

// The middle value, which a few far ones do not move.
#pragma once

#include <algorithm>
#include <vector>

namespace adit::dem {

// The mean of the two middle ones where their number is even; `values` is not empty.
inline double median(std::vector<double> values) {
  const std::size_t half = values.size() / 2;
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(half));
  const double upper = values[half];
  if (values.size() % 2 == 1) return upper;
  return (upper + *std::max_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(half))) / 2;
}

}  // namespace adit::dem

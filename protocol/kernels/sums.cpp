#include "protocol/kernels/sums.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "protocol/threads/vector_clones.hpp"

namespace adit::protocol {
namespace {

// The order of squares, which are not negative, is that of their bits: the compiler makes vector code of a
// maximum of integers, not of one of doubles, because of NaN.
[[gnu::always_inline]] inline std::int64_t bits_of_square(double x, double y) {
  return std::bit_cast<std::int64_t>(x * x + y * y) & 0x7fff'ffff'ffff'ffff;
}

ADIT_VECTOR_CLONES std::int64_t largest_bits(std::span<const double> x, std::span<const double> y) {
  std::int64_t largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) largest = std::max(largest, bits_of_square(x[i], y[i]));
  return largest;
}

}  // namespace

ADIT_VECTOR_CLONES double sum_of(std::span<const double> values) {
  return eight_sums(0, values.size(), [&](std::size_t i) { return values[i]; });
}

ADIT_VECTOR_CLONES double sum_of_sizes(std::span<const double> x, std::span<const double> y) {
  return eight_sums(0, x.size(), [&](std::size_t i) { return std::sqrt(x[i] * x[i] + y[i] * y[i]); });
}

VectorSizes sizes_of(std::span<const double> x, std::span<const double> y) {
  if (x.empty()) return {};
  const std::int64_t largest = largest_bits(x, y);
  std::size_t at = 0;
  while (bits_of_square(x[at], y[at]) != largest) ++at;
  return {sum_of_sizes(x, y), std::sqrt(x[at] * x[at] + y[at] * y[at]), at};
}

}  // namespace adit::protocol

// Sums of many numbers, and of the sizes of many vectors of the plane.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <span>

namespace adit::protocol {

// A sum of many values as eight sums side by side: else each addition would wait for the one before, and the
// loops would not become vector code. Which values go into which sum does not depend on the processor.
// Of value(begin) … value(end - 1), which may also write what no other one reads.
template <class Value>
[[gnu::always_inline]] inline double eight_sums(std::size_t begin, std::size_t end, Value&& value) {
  constexpr std::size_t kSums = 8, kAtATime = 128;
  if (end - begin < kSums) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += value(i);
    return sum;
  }
  alignas(64) std::array<double, kSums> sums{};
  alignas(64) std::array<double, kAtATime> values;
  for (std::size_t at = begin; at < end; at += kAtATime) {
    const std::size_t count = std::min(kAtATime, end - at), whole = (count + kSums - 1) / kSums * kSums;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) values[k] = value(at + k);
    std::fill(values.begin() + count, values.begin() + whole, 0.0);
    for (std::size_t k = 0; k < whole; k += kSums)
      for (std::size_t lane = 0; lane < kSums; ++lane) sums[lane] += values[k + lane];
  }
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

double sum_of(std::span<const double> values);

// Of |(x[i], y[i])|.
double sum_of_sizes(std::span<const double> x, std::span<const double> y);

struct VectorSizes {
  double sum = 0, largest = 0;
  std::size_t at = 0;  // the first of the largest
};
// Of (x[i], y[i]). Vectors that are not finite are larger than all others.
VectorSizes sizes_of(std::span<const double> x, std::span<const double> y);

}  // namespace adit::protocol

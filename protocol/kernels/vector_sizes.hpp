// Sums of many numbers, and of the sizes of many vectors of the plane.
#pragma once

#include <cstddef>
#include <span>

namespace adit::protocol {

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

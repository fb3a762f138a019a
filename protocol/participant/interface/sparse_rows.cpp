#include "protocol/participant/interface/sparse_rows.hpp"

#include <algorithm>
#include <utility>

namespace adit::protocol {

SparseRows::SparseRows(std::vector<std::uint32_t> row_starts, std::vector<std::uint32_t> columns,
                       std::vector<double> values)
    : row_starts_(std::move(row_starts)), columns_(std::move(columns)), values_(std::move(values)) {}

// Both loops find x and y of a point by one address and read the entry once, so that the compiler makes one
// vector of the pair.
void SparseRows::gather(std::span<const double> impulses, std::span<double> own) const {
  std::ranges::fill(own, 0.0);
  for (std::size_t k = 0; k < rows(); ++k) {
    const double x = impulses[2 * k], y = impulses[2 * k + 1];
    for (std::uint32_t e = row_starts_[k]; e < row_starts_[k + 1]; ++e) {
      const double value = values_[e];
      double* point = own.data() + 2 * std::size_t{columns_[e]};
      point[0] += value * x;
      point[1] += value * y;
    }
  }
}

void SparseRows::interpolate(std::span<const double> own, std::span<double> velocities) const {
  for (std::size_t k = 0; k < rows(); ++k) {
    double x = 0, y = 0;
    for (std::uint32_t e = row_starts_[k]; e < row_starts_[k + 1]; ++e) {
      const double value = values_[e];
      const double* point = own.data() + 2 * std::size_t{columns_[e]};
      x += value * point[0];
      y += value * point[1];
    }
    velocities[2 * k] = x;
    velocities[2 * k + 1] = y;
  }
}

}  // namespace adit::protocol

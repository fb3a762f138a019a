#include "protocol/participant/sparse_rows.hpp"

#include <algorithm>
#include <utility>

namespace adit::protocol {

SparseRows::SparseRows(std::vector<std::uint32_t> row_starts, std::vector<std::uint32_t> columns,
                       std::vector<double> values)
    : row_starts_(std::move(row_starts)), columns_(std::move(columns)), values_(std::move(values)) {}

// Plain pointers in both: the bounds are those of the rows, and x and y of a pair are one vector of the
// processor.
void SparseRows::gather(std::span<const double> impulses, std::span<double> own) const {
  std::ranges::fill(own, 0.0);
  const std::uint32_t* column = columns_.data();
  const double* value = values_.data();
  double* out = own.data();
  for (std::size_t k = 0; k < rows(); ++k) {
    const double x = impulses[2 * k], y = impulses[2 * k + 1];
    for (std::uint32_t e = row_starts_[k]; e < row_starts_[k + 1]; ++e) {
      out[2 * column[e]] += value[e] * x;
      out[2 * column[e] + 1] += value[e] * y;
    }
  }
}

void SparseRows::interpolate(std::span<const double> own, std::span<double> velocities) const {
  const std::uint32_t* column = columns_.data();
  const double* value = values_.data();
  const double* in = own.data();
  for (std::size_t k = 0; k < rows(); ++k) {
    double x = 0, y = 0;
    for (std::uint32_t e = row_starts_[k]; e < row_starts_[k + 1]; ++e) {
      x += value[e] * in[2 * column[e]];
      y += value[e] * in[2 * column[e] + 1];
    }
    velocities[2 * k] = x;
    velocities[2 * k + 1] = y;
  }
}

}  // namespace adit::protocol

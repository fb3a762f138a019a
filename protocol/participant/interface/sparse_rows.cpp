#include "protocol/participant/interface/sparse_rows.hpp"

#include <algorithm>
#include <utility>

namespace adit::protocol {
namespace {

constexpr std::size_t kFour = 4;

// Of rows that have the same four columns, the first entry, and how many they are.
struct Four {
  const std::uint32_t* columns;
  const double* values;
  std::size_t rows;
};

using Pair [[gnu::vector_size(16)]] = double;  // x and y

Pair pair(const double* from) {
  return Pair{from[0], from[1]};
}

void store(const Pair& values, double* to) {
  to[0] = values[0];
  to[1] = values[1];
}

void gather_four(const Four& four, const double* impulses, double* own) {
  double* points[kFour];
  for (std::size_t e = 0; e < kFour; ++e) points[e] = own + 2 * std::size_t{four.columns[e]};
  Pair a = pair(points[0]), b = pair(points[1]), c = pair(points[2]), d = pair(points[3]);
  const double* values = four.values;
  for (std::size_t k = 0; k < four.rows; ++k, values += kFour) {
    const Pair impulse = pair(impulses + 2 * k);
    a += values[0] * impulse;
    b += values[1] * impulse;
    c += values[2] * impulse;
    d += values[3] * impulse;
  }
  store(a, points[0]);
  store(b, points[1]);
  store(c, points[2]);
  store(d, points[3]);
}

void interpolate_four(const Four& four, const double* own, double* velocities) {
  const auto point = [&](std::size_t e) { return pair(own + 2 * std::size_t{four.columns[e]}); };
  const Pair a = point(0), b = point(1), c = point(2), d = point(3);
  const double* values = four.values;
  for (std::size_t k = 0; k < four.rows; ++k, values += kFour)
    store(Pair{} + values[0] * a + values[1] * b + values[2] * c + values[3] * d, velocities + 2 * k);
}

}  // namespace

SparseRows::SparseRows(std::vector<std::uint32_t> row_starts, std::vector<std::uint32_t> columns,
                       std::vector<double> values)
    : row_starts_(std::move(row_starts)), columns_(std::move(columns)), values_(std::move(values)) {
  for (std::size_t k = 0; k < rows(); ++k) {
    const auto of_row = this->columns(k);
    const bool four = of_row.size() == kFour;
    const bool goes_on = !runs_.empty() && runs_.back().same_four == four &&
                         (!four || std::ranges::equal(of_row, this->columns(k - 1)));
    if (goes_on)
      ++runs_.back().end;
    else
      runs_.push_back({k, k + 1, four});
  }
}

// The loops over single rows find x and y of a point by one address and read the entry once, so that the
// compiler makes one vector of the pair.
void SparseRows::gather(std::span<const double> impulses, std::span<double> own) const {
  std::ranges::fill(own, 0.0);
  for (const auto& [begin, end, same_four] : runs_) {
    if (same_four) {
      const std::uint32_t first = row_starts_[begin];
      gather_four({&columns_[first], &values_[first], end - begin}, &impulses[2 * begin], own.data());
      continue;
    }
    for (std::size_t k = begin; k < end; ++k) {
      const double x = impulses[2 * k], y = impulses[2 * k + 1];
      for (std::uint32_t e = row_starts_[k]; e < row_starts_[k + 1]; ++e) {
        const double value = values_[e];
        double* point = own.data() + 2 * std::size_t{columns_[e]};
        point[0] += value * x;
        point[1] += value * y;
      }
    }
  }
}

void SparseRows::interpolate(std::span<const double> own, std::span<double> velocities) const {
  for (const auto& [begin, end, same_four] : runs_) {
    if (same_four) {
      const std::uint32_t first = row_starts_[begin];
      interpolate_four({&columns_[first], &values_[first], end - begin}, own.data(), &velocities[2 * begin]);
      continue;
    }
    for (std::size_t k = begin; k < end; ++k) {
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
}

}  // namespace adit::protocol

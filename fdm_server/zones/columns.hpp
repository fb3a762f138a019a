// Structure of arrays: columns of equal length in one allocation.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace adit::fdm {

template <std::size_t kColumns>
class Columns {
 public:
  explicit Columns(std::size_t rows) : rows_(rows), stride_(padded(rows)), data_(kColumns * stride_, 0.0) {}

  std::size_t rows() const { return rows_; }
  std::span<double> operator[](std::size_t column) { return {data_.data() + column * stride_, rows_}; }
  std::span<const double> operator[](std::size_t column) const {
    return {data_.data() + column * stride_, rows_};
  }

 private:
  // Columns a multiple of 4 KiB apart fall on the same sets of the cache and evict each other: the stride
  // is a multiple of 4 KiB plus a few cache lines, so that the same row of all columns is spread.
  static std::size_t padded(std::size_t rows) {
    constexpr std::size_t kPage = 4096 / sizeof(double), kShift = 320 / sizeof(double);
    return (rows + kPage - 1) / kPage * kPage + kShift;
  }

  std::size_t rows_;
  std::size_t stride_;
  std::vector<double> data_;
};

}  // namespace adit::fdm

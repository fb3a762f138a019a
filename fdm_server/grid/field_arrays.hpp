// Several fields over the same points or zones, as a structure of arrays of equal length in one allocation.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "protocol/kernels/prefetch.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

template <std::size_t kFields>
class FieldArrays {
 public:
  explicit FieldArrays(std::size_t size)
      : size_(size), stride_(padded(size)), data_(kFields * stride_, 0.0) {}

  std::size_t size() const { return size_; }  // values of each field
  std::span<double> operator[](std::size_t field) { return {data_.data() + field * stride_, size_}; }
  std::span<const double> operator[](std::size_t field) const {
    return {data_.data() + field * stride_, size_};
  }

  // Of `count` values of each field.
  void prefetch(std::size_t first, std::size_t count) const {
    const std::size_t begin = std::min(first, size_), end = std::min(first + count, size_);
    for (std::size_t field = 0; field < kFields; ++field)
      protocol::prefetch((*this)[field].subspan(begin, end - begin));
  }

  void exchange(state::Archive& archive) {
    for (std::size_t field = 0; field < kFields; ++field) archive("field", (*this)[field]);
  }

 private:
  // Arrays a multiple of 4 KiB apart fall on the same sets of the cache and evict each other: the stride is a
  // multiple of 4 KiB plus a few cache lines, so that the same place in all arrays is spread.
  static std::size_t padded(std::size_t size) {
    constexpr std::size_t kPage = 4096 / sizeof(double), kShift = 320 / sizeof(double);
    return (size + kPage - 1) / kPage * kPage + kShift;
  }

  std::size_t size_;
  std::size_t stride_;
  std::vector<double> data_;
};

}  // namespace adit::fdm

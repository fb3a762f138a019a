// Several fields over the same points or zones, as a structure of arrays of equal length in one allocation.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

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

  // Asks for `count` values of each field, so that they are in the cache when they are wanted: a processor
  // does not follow so many arrays by itself.
  void prefetch(std::size_t first, std::size_t count) const {
    constexpr std::size_t kLine = 64 / sizeof(double);
    const std::size_t end = std::min(first + count, size_);
    for (std::size_t field = 0; field < kFields; ++field)
      for (std::size_t i = first; i < end; i += kLine)
        __builtin_prefetch(data_.data() + field * stride_ + i, 1);
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

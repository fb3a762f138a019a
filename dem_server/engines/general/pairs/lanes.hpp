// Rows of values become columns, in registers: a pair finds its discs as rows, the laws want columns of
// pairs.
#pragma once

#include <cstdint>
#include <cstring>

namespace adit::dem {

inline constexpr std::uint32_t kLanes = 8;  // pairs that are turned at a time

using Four [[gnu::vector_size(32)]] = double;
using Eight [[gnu::vector_size(64)]] = double;

// From and to any place of a list: by copies, because not all compilers let a reference to a vector lie
// anywhere.
template <class Values>
[[gnu::always_inline]] inline void load(const double* from, Values& to) {
  std::memcpy(&to, from, sizeof to);
}
[[gnu::always_inline]] inline Four four(const double* from) {
  Four values;
  load(from, values);
  return values;
}
[[gnu::always_inline]] inline void store(const Four& values, double* to) {
  std::memcpy(to, &values, sizeof values);
}

[[gnu::always_inline]] inline Four low_half(const Eight& values) {
  return __builtin_shufflevector(values, values, 0, 1, 2, 3);
}
[[gnu::always_inline]] inline Four high_half(const Eight& values) {
  return __builtin_shufflevector(values, values, 4, 5, 6, 7);
}

// Four rows of four become four columns of four.
[[gnu::always_inline]] inline void turn(Four* rows) {
  const Four even_01 = __builtin_shufflevector(rows[0], rows[1], 0, 4, 2, 6),
             odd_01 = __builtin_shufflevector(rows[0], rows[1], 1, 5, 3, 7),
             even_23 = __builtin_shufflevector(rows[2], rows[3], 0, 4, 2, 6),
             odd_23 = __builtin_shufflevector(rows[2], rows[3], 1, 5, 3, 7);
  rows[0] = __builtin_shufflevector(even_01, even_23, 0, 1, 4, 5);
  rows[1] = __builtin_shufflevector(odd_01, odd_23, 0, 1, 4, 5);
  rows[2] = __builtin_shufflevector(even_01, even_23, 2, 3, 6, 7);
  rows[3] = __builtin_shufflevector(odd_01, odd_23, 2, 3, 6, 7);
}

}  // namespace adit::dem

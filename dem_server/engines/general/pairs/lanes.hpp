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

[[gnu::always_inline]] inline void store(const Eight& values, double* to) {
  std::memcpy(to, &values, sizeof values);
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

// Eight rows of eight become eight columns of eight. pairs: of two rows each, their values 0, 2, 4, 6, then
// 1, 3, 5, 7; fours: of four rows each, their values 0 and 4, 1 and 5, 2 and 6, 3 and 7.
[[gnu::always_inline]] inline void turn(Eight* rows) {
  Eight pairs[8], fours[8];
  for (int k = 0; k < 8; k += 2) {
    pairs[k] = __builtin_shufflevector(rows[k], rows[k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    pairs[k + 1] = __builtin_shufflevector(rows[k], rows[k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  for (int k = 0; k < 8; k += 4)
    for (int odd = 0; odd < 2; ++odd) {
      const Eight &a = pairs[k + odd], &b = pairs[k + 2 + odd];
      fours[k + odd] = __builtin_shufflevector(a, b, 0, 1, 4, 5, 8, 9, 12, 13);
      fours[k + 2 + odd] = __builtin_shufflevector(a, b, 2, 3, 6, 7, 10, 11, 14, 15);
    }
  for (int k = 0; k < 4; ++k) {
    const Eight &a = fours[k], &b = fours[4 + k];
    rows[k] = __builtin_shufflevector(a, b, 0, 1, 4, 5, 8, 9, 12, 13);
    rows[4 + k] = __builtin_shufflevector(a, b, 2, 3, 6, 7, 10, 11, 14, 15);
  }
}

}  // namespace adit::dem

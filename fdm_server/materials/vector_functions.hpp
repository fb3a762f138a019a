// Functions of numbers that the compiler makes vectors of: without branches and calls, the same to the last
// bit for whatever width of vector.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace adit::fdm::vectors {

[[gnu::always_inline]] inline double larger(double a, double b) {
  return a > b ? a : b;
}
[[gnu::always_inline]] inline double smaller(double a, double b) {
  return a < b ? a : b;
}
[[gnu::always_inline]] inline double positive(double a) {
  return a > 0 ? a : 0;
}
[[gnu::always_inline]] inline double square(double a) {
  return a * a;
}
// Of what is not negative, as abs() tells the compiler.
[[gnu::always_inline]] inline double root(double a) {
  return std::sqrt(std::abs(a));
}

// One of two numbers by its bits: of ?: the compiler would make a branch round the longer side.
[[gnu::always_inline]] inline double choose(bool first, double a, double b) {
  const std::uint64_t mask = -static_cast<std::uint64_t>(first);
  return std::bit_cast<double>((std::bit_cast<std::uint64_t>(a) & mask) |
                               (std::bit_cast<std::uint64_t>(b) & ~mask));
}

// exp(x) to a few units in the last place, for x up to 700: 2^k of the nearest k, times the series of what is
// left, which is less than ln(2)/2.
[[gnu::always_inline]] inline double exponential(double x) {
  constexpr double kShift = 0x1.8p52;                                             // rounds to whole numbers
  constexpr double kLn2High = 0x1.62e42fefap-1, kLn2Low = 0x1.cf79abc9e3b3ap-40;  // ln(2), the former short
  const double bounded = larger(x, -700), shifted = bounded * std::numbers::log2e + kShift;
  const double k = shifted - kShift, f = (bounded - k * kLn2High) - k * kLn2Low;
  constexpr double kSeries[] = {
      1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320, 1.0 / 5040, 1.0 / 720,
      1.0 / 120,      1.0 / 24,      1.0 / 6,      1.0 / 2,     1,          1};
  double sum = 1.0 / 479001600;
  for (const double c : kSeries) sum = sum * f + c;
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(sum) +
                               (std::bit_cast<std::uint64_t>(shifted) << 52));
}

// ln(x) to a few units in the last place, for normal x > 0: of 2^k, and of the rest m between sqrt(1/2) and
// sqrt(2) by the series of 2 artanh((m - 1)/(m + 1)).
[[gnu::always_inline]] inline double logarithm(double x) {
  constexpr std::uint64_t kOne = 0x3ff0000000000000, kRootOfHalf = 0x3fe6a09e667f3bcd,
                          kMantissa = 0x000fffffffffffff;
  constexpr std::uint64_t kTwo52 = 0x4330000000000000;  // 2^52, whose last bits are a whole number
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x) + (kOne - kRootOfHalf);
  const double k = std::bit_cast<double>((bits >> 52) | kTwo52) - (0x1p52 + 1023);
  const double m = std::bit_cast<double>((bits & kMantissa) + kRootOfHalf);
  const double f = (m - 1) / (m + 1), f2 = f * f;
  constexpr double kSeries[] = {1.0 / 15, 1.0 / 13, 1.0 / 11, 1.0 / 9, 1.0 / 7, 1.0 / 5, 1.0 / 3, 1};
  double sum = 1.0 / 17;
  for (const double c : kSeries) sum = sum * f2 + c;
  return k * std::numbers::ln2 + 2 * f * sum;
}

}  // namespace adit::fdm::vectors

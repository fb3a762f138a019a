#include "dem_server/model/placement/written_numbers.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace adit::dem {

void WrittenNumbers::add(std::string_view word, double value) {
  const auto end_of_digits = std::min(word.find_first_of("eE"), word.size());
  int exponent = 0;
  if (end_of_digits < word.size()) {
    auto first = word.data() + end_of_digits + 1;
    if (first < word.data() + word.size() && *first == '+') ++first;
    std::from_chars(first, word.data() + word.size(), exponent);
  }
  int digits = 0, decimals = 0;
  bool after_point = false;
  for (const char c : word.substr(0, end_of_digits)) {
    if (c == '.') after_point = true;
    if (c < '0' || c > '9') continue;
    if (digits > 0 || c != '0') ++digits;
    if (after_point) ++decimals;
  }
  digits_ = std::max(digits_, digits);
  decimals_ = std::max(decimals_, decimals - exponent);
  largest_ = std::max(largest_, std::abs(value));
}

double WrittenNumbers::rounding() const {
  if (largest_ == 0) return 0;
  const double by_decimals = std::pow(10.0, -decimals_);
  const double by_digits = std::pow(10.0, std::floor(std::log10(largest_)) + 1 - digits_);
  return std::max(by_decimals, by_digits) / 2;
}

}  // namespace adit::dem

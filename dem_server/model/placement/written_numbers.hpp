// How finely numbers are written in a text.
#pragma once

#include <string_view>

namespace adit::dem {

// A column of numbers with as many decimals (%.6f), or as many digits (%.6g), as the finest of them shows.
class WrittenNumbers {
 public:
  void add(std::string_view word, double value);

  // Half a unit of the last digit of the largest number; 0 for none.
  double rounding() const;

 private:
  int decimals_ = 0, digits_ = 0;  // the most of all
  double largest_ = 0;
};

}  // namespace adit::dem

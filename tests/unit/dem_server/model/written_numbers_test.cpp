// Requirement: a column of numbers is known to half a unit of the last digit that its finest number shows.
#include "dem_server/model/placement/written_numbers.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <initializer_list>
#include <string>

namespace adit::dem::written_numbers_test {
namespace {

double rounding_of(std::initializer_list<std::string> words) {
  WrittenNumbers numbers;
  for (const std::string& word : words) numbers.add(word, std::strtod(word.c_str(), nullptr));
  return numbers.rounding();
}

TEST(WrittenNumbers, HaveDecimals) {
  EXPECT_DOUBLE_EQ(rounding_of({"0.125", "2.5", "10.250000"}), 0.5e-6);
  EXPECT_DOUBLE_EQ(rounding_of({"-3"}), 0.5);
}

TEST(WrittenNumbers, HaveDigitsWhereTheyAreFewerThanTheDecimalsOfSmallOnes) {
  EXPECT_DOUBLE_EQ(rounding_of({"0.000123456", "12.3456"}), 0.5e-4);
  EXPECT_DOUBLE_EQ(rounding_of({"1.25e-3", "2.00e+1"}), 0.05);
}

TEST(WrittenNumbers, OfNothingAreExact) {
  EXPECT_EQ(rounding_of({}), 0);
  EXPECT_EQ(rounding_of({"0.0"}), 0);
}

}  // namespace
}  // namespace adit::dem::written_numbers_test

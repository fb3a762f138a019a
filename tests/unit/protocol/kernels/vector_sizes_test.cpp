// Sums and largest values of many vectors, by hand.
#include "protocol/kernels/sums.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace adit::protocol::vector_sizes_test {
namespace {

// Lengths around those of whole vectors and of a whole piece of the sum.
TEST(VectorSizes, AreSummedAndTheFirstOfTheLargestIsFound) {
  for (const std::size_t count : {1u, 7u, 8u, 9u, 127u, 128u, 129u, 1000u})
    for (const std::size_t at : {std::size_t{0}, count / 2, count - 1}) {
      std::vector<double> x(count, 3), y(count, -4);
      x[at] = -6;
      y[at] = 8;
      const VectorSizes sizes = sizes_of(x, y);
      EXPECT_EQ(sizes.sum, 5.0 * static_cast<double>(count) + 5) << count;
      EXPECT_EQ(sizes.largest, 10);
      EXPECT_EQ(sizes.at, at);
    }
}

TEST(VectorSizes, OfNothingAreNothing) {
  const VectorSizes sizes = sizes_of({}, {});
  EXPECT_EQ(sizes.sum, 0);
  EXPECT_EQ(sizes.largest, 0);
}

// A model that blows up is told, not passed over.
TEST(VectorSizes, WhatIsNotANumberIsTheLargest) {
  std::vector<double> x(20, 1), y(20, 1);
  x[13] = std::numeric_limits<double>::quiet_NaN();
  const VectorSizes sizes = sizes_of(x, y);
  EXPECT_TRUE(std::isnan(sizes.sum));
  EXPECT_TRUE(std::isnan(sizes.largest));
  EXPECT_EQ(sizes.at, 13u);
}

}  // namespace
}  // namespace adit::protocol::vector_sizes_test

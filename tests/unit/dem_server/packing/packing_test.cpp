#include "dem_server/packing/hexagonal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "tests/unit/dem_server/engines/lattice/lattice.hpp"

namespace adit::dem {
namespace {

constexpr double kRadius = 10.0 / 156;
const Rectangle kCantilever{0, 10, 0, 9 * std::numbers::sqrt3* kRadius};

// The cantilever of the paper has 9 rows of 78 and 77 discs, 698 in all, and 1921 bonds.
TEST(Packing, CantileverHasItsCounts) {
  const Packing p = pack_hexagonally(kCantilever, kRadius);
  EXPECT_EQ(p.x.size(), 698u);
  EXPECT_EQ(p.links.size(), 1921u);
  EXPECT_EQ(count_hexagonal(kCantilever, kRadius), 698);
  EXPECT_NEAR(p.x[0], kRadius, 1e-14);
  EXPECT_NEAR(p.x[78], 2 * kRadius, 1e-14);
  EXPECT_NEAR(p.y[0], std::numbers::sqrt3 / 2 * kRadius, 1e-14);
  EXPECT_NEAR(p.x[77], 10 - kRadius, 1e-13);
}

// Linked discs are those that touch, each pair once, and the rest vectors are their distances.
TEST(Packing, LinksJoinExactlyTheTouchingDiscs) {
  for (const auto& [rows, discs] : {std::pair{5, 4}, {4, 1}, {1, 7}, {2, 2}}) {
    const double radius = 0.3;
    const Packing p = test::rows_of(rows, discs, radius);
    std::set<std::pair<std::uint32_t, std::uint32_t>> linked;
    for (const Link& link : p.links) {
      const auto [dx, dy] = rest_vector(link.direction, radius);
      EXPECT_NEAR(p.x[link.second] - p.x[link.first], dx, 1e-13);
      EXPECT_NEAR(p.y[link.second] - p.y[link.first], dy, 1e-13);
      EXPECT_TRUE(linked.insert({link.first, link.second}).second);
    }
    for (std::uint32_t i = 0; i < p.x.size(); ++i)
      for (std::uint32_t j = i + 1; j < p.x.size(); ++j)
        EXPECT_EQ(std::hypot(p.x[j] - p.x[i], p.y[j] - p.y[i]) < 2.001 * radius, linked.contains({i, j}))
            << i << " " << j;
  }
}

// Rows and discs that do not fill the box are centred in it.
TEST(Packing, IsCentredInTheBox) {
  const Packing p = pack_hexagonally({-1, 2.5, 4, 6.2}, 0.5);
  EXPECT_EQ(p.x.size(), 5u);  // 3 discs below, 2 above
  EXPECT_DOUBLE_EQ(p.cells.x_min + p.cells.x_max, 1.5);
  EXPECT_DOUBLE_EQ(p.cells.y_min + p.cells.y_max, 10.2);
  EXPECT_DOUBLE_EQ(p.x[1], 0.75);
  EXPECT_DOUBLE_EQ(p.y[0] + p.y[4], 10.2);
}

// A box smaller than one disc and its row holds nothing.
TEST(Packing, SmallBoxHoldsNothing) {
  EXPECT_TRUE(pack_hexagonally({0, 0.9, 0, 5}, 0.5).x.empty());
  EXPECT_TRUE(pack_hexagonally({0, 5, 0, 0.8}, 0.5).x.empty());
  EXPECT_EQ(count_hexagonal({0, 1e300, 0, 1e300}, 1e-300), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace adit::dem

#include "dem_server/packing/regular.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "tests/unit/dem_server/engines/lattice/lattice.hpp"

namespace adit::dem::packing_test {
namespace {

constexpr double kRadius = 10.0 / 156;
const geometry::BoundingBox kCantilever{0, 10, 0, 9 * std::numbers::sqrt3* kRadius};

// The cantilever of the paper has 9 rows of 78 and 77 discs, 698 in all, and 1921 bonds.
TEST(Packing, CantileverHasItsCounts) {
  const auto lattice = test::lattice_in(kCantilever, kRadius);
  const Discs& p = lattice.discs;
  EXPECT_EQ(p.x.size(), 698u);
  EXPECT_EQ(lattice.bonds.size(), 1921u);
  EXPECT_EQ(count_hexagonal(kCantilever, kRadius), 698);
  EXPECT_NEAR(p.x[0], kRadius, 1e-14);
  EXPECT_NEAR(p.x[78], 2 * kRadius, 1e-14);
  EXPECT_NEAR(p.y[0], std::numbers::sqrt3 / 2 * kRadius, 1e-14);
  EXPECT_NEAR(p.x[77], 10 - kRadius, 1e-13);
}

// Bonded discs are those that touch, each pair once, and the rest vectors are their distances.
TEST(Packing, BondsJoinExactlyTheTouchingDiscs) {
  for (const auto& [rows, discs] : {std::pair{5, 4}, {4, 1}, {1, 7}, {2, 2}}) {
    const double radius = 0.3;
    const Model model = test::rows_of(rows, discs, radius);
    const Discs& p = model.discs;
    std::set<std::pair<std::uint32_t, std::uint32_t>> bonded;
    for (const Bond& bond : model.bonds) {
      const auto [dx, dy] = rest_vector(direction_of(model, bond).value(), radius);
      EXPECT_NEAR(p.x[bond.second] - p.x[bond.first], dx, 1e-13);
      EXPECT_NEAR(p.y[bond.second] - p.y[bond.first], dy, 1e-13);
      EXPECT_TRUE(bonded.insert({bond.first, bond.second}).second);
    }
    for (std::uint32_t i = 0; i < p.x.size(); ++i)
      for (std::uint32_t j = i + 1; j < p.x.size(); ++j)
        EXPECT_EQ(std::hypot(p.x[j] - p.x[i], p.y[j] - p.y[i]) < 2.001 * radius, bonded.contains({i, j}))
            << i << " " << j;
  }
}

// Rows and discs that do not fill the box are centred in it.
TEST(Packing, IsCentredInTheBox) {
  const auto [p, cells] = pack_hexagonally({-1, 2.5, 4, 6.2}, 0.5);
  EXPECT_EQ(p.x.size(), 5u);  // 3 discs below, 2 above
  EXPECT_DOUBLE_EQ(cells.x_min + cells.x_max, 1.5);
  EXPECT_DOUBLE_EQ(cells.y_min + cells.y_max, 10.2);
  EXPECT_DOUBLE_EQ(p.x[1], 0.75);
  EXPECT_DOUBLE_EQ(p.y[0] + p.y[4], 10.2);
}

// A box smaller than one disc and its row holds nothing.
TEST(Packing, SmallBoxHoldsNothing) {
  EXPECT_TRUE(pack_hexagonally({0, 0.9, 0, 5}, 0.5).discs.x.empty());
  EXPECT_TRUE(pack_hexagonally({0, 5, 0, 0.8}, 0.5).discs.x.empty());
  EXPECT_EQ(count_hexagonal({0, 1e300, 0, 1e300}, 1e-300), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace adit::dem::packing_test

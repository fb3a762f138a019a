#include "dem_server/engines/crack.hpp"

#include <gtest/gtest.h>

#include "tests/unit/dem_server/engines/lattice/lattice.hpp"

namespace adit::dem::crack_test {
namespace {

// A crack lies where the particles touched, across the bond, and is as long as the cells' common edge.
TEST(Crack, IsTheCommonEdgeOfTheCells) {
  const double radius = 0.5;
  const Assembly a = test::assemble(test::rows_of(2, 3, radius), 1.0);
  std::size_t seen[3] = {0, 0, 0};
  for (std::uint32_t k = 0; k < a.bonds.size(); ++k) {
    const Particles& p = a.particles;
    const std::uint32_t i = a.bonds.first[k], j = a.bonds.second[k];
    const Crack crack = crack_between(p, i, j, 0, BondState::kShearCrack);
    EXPECT_EQ(crack.mode, BondState::kShearCrack);
    EXPECT_EQ(crack.parent_a, p.id[i]);
    EXPECT_EQ(crack.parent_b, p.id[j]);
    EXPECT_DOUBLE_EQ(crack.x, (p.x[i] + p.x[j]) / 2);
    EXPECT_DOUBLE_EQ(crack.y, (p.y[i] + p.y[j]) / 2);
    EXPECT_DOUBLE_EQ(6 * crack.length * radius / 2, 2 * std::numbers::sqrt3 * radius * radius)
        << "six edges at the distance R enclose a cell";
    const double along_bond =
        std::cos(crack.orientation) * (p.x[j] - p.x[i]) + std::sin(crack.orientation) * (p.y[j] - p.y[i]);
    EXPECT_NEAR(along_bond, 0, 1e-15);
    EXPECT_GT(crack.orientation, -std::numbers::pi / 2);
    EXPECT_LE(crack.orientation, std::numbers::pi / 2);
    seen[p.y[i] == p.y[j] ? 0 : p.x[j] > p.x[i] ? 1 : 2]++;
  }
  for (const std::size_t count : seen) EXPECT_GT(count, 0u);
}

// A bond along a row leaves an upright crack: pi/2, not -pi/2.
TEST(Crack, UprightCrackHasAPositiveAngle) {
  const Particles p = test::pair_of_particles().particles;
  for (const auto& [i, j] : {std::pair(0u, 1u), {1u, 0u}})
    EXPECT_DOUBLE_EQ(crack_between(p, i, j, 0, BondState::kTensileCrack).orientation, std::numbers::pi / 2);
}

}  // namespace
}  // namespace adit::dem::crack_test

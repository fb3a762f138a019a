#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dem_server/packing/random/pressed_discs.hpp"
#include "dem_server/packing/random/random_dense.hpp"
#include "dem_server/packing/regular.hpp"

namespace adit::dem::random_packing_test {
namespace {

const RandomPacking kWanted{{-1, 2, 5, 6}, 0.03, 0.05, 0.16, 1e-3, 7};

// The walls feel the stress asked for, within the 1 % that is promised, alike in both directions; whatever
// the discs that were drawn, and from the loosest packing on that is jammed.
TEST(RandomPacking, ReachesTheIsotropicStress) {
  RandomPacking wanted = kWanted;
  for (const double stress : {1e-4, 1e-3, 1e-2})
    for (wanted.seed = 1; wanted.seed <= 4; ++wanted.seed) {
      wanted.stress = stress;
      const auto grown = pack_randomly(wanted);
      ASSERT_TRUE(grown);
      const double mean = (grown->state.stress_x + grown->state.stress_y) / 2;
      EXPECT_NEAR(mean, stress, 0.01 * stress) << "seed " << wanted.seed;
      EXPECT_NEAR(grown->state.stress_x, grown->state.stress_y, 0.15 * stress) << "seed " << wanted.seed;
    }
}

// Frictionless discs jam at a porosity of 0.16 (O'Hern, Silbert, Liu & Nagel 2003, Phys. Rev. E 68, 011306:
// 0.158 for large systems) with four contacts a disc, and walls need some more room.
TEST(RandomPacking, JamsWhereFrictionlessDiscsDo) {
  RandomPacking wanted = kWanted;
  wanted.stress = 1e-4;
  const auto grown = pack_randomly(wanted);
  ASSERT_TRUE(grown);
  EXPECT_GT(grown->state.porosity, 0.15);
  EXPECT_LT(grown->state.porosity, 0.19);
  EXPECT_NEAR(grown->state.coordination, 4, 0.2);
}

// A porosity far above the jamming one is reached from by growing the radii.
TEST(RandomPacking, GrowsDiscsThatWereDrawnTooFew) {
  RandomPacking wanted = kWanted;
  wanted.porosity = 0.3;
  const auto grown = pack_randomly(wanted);
  ASSERT_TRUE(grown);
  EXPECT_GT(grown->state.radius_factor, 1.05);
  EXPECT_LT(grown->state.porosity, 0.19);
}

// Every disc lies in the box but for its overlap with a wall, keeps its size in the range times the radius
// factor, and has at least three contacts.
TEST(RandomPacking, KeepsDiscsInTheBoxAndInTheirRangeOfSizes) {
  const auto grown = pack_randomly(kWanted);
  ASSERT_TRUE(grown);
  const auto& [x, y, radius] = grown->discs;
  const double factor = grown->state.radius_factor;
  for (std::size_t i = 0; i < grown->discs.size(); ++i) {
    EXPECT_GE(radius[i], kWanted.radius_min * factor * (1 - 1e-12));
    EXPECT_LE(radius[i], kWanted.radius_max * factor * (1 + 1e-12));
    EXPECT_GE(x[i], kWanted.box.x_min + 0.95 * radius[i]);
    EXPECT_LE(x[i], kWanted.box.x_max - 0.95 * radius[i]);
    EXPECT_GE(y[i], kWanted.box.y_min + 0.95 * radius[i]);
    EXPECT_LE(y[i], kWanted.box.y_max - 0.95 * radius[i]);
  }
  protocol::Team team;
  PressedDiscs pressed(grown->discs, kWanted.box, team);
  const auto keep = without_floaters(grown->discs.size(), pressed.contacts(), pressed.wall_contacts(), 3);
  EXPECT_EQ(std::ranges::count(keep, false), 0);
}

// The same seed gives the same packing to the bit, another seed another one.
TEST(RandomPacking, FollowsItsSeed) {
  RandomPacking other = kWanted;
  other.seed = 8;
  const auto a = pack_randomly(kWanted), b = pack_randomly(kWanted), c = pack_randomly(other);
  ASSERT_TRUE(a && b && c);
  EXPECT_EQ(a->discs.x, b->discs.x);
  EXPECT_EQ(a->discs.radius, b->discs.radius);
  EXPECT_NE(a->discs.x, c->discs.x);
}

// Several blocks of discs, shared by one to three threads: the same packing to the bit.
TEST(RandomPacking, DoesNotDependOnTheNumberOfThreads) {
  RandomPacking wanted = kWanted;
  wanted.box = {0, 6, 0, 5};
  wanted.radius_min = 0.05;
  wanted.radius_max = 0.06;
  wanted.stress = 1e-2;
  const auto alone = pack_randomly(wanted);
  ASSERT_TRUE(alone);
  EXPECT_GT(alone->discs.size(), 2 * 1024u);
  for (const std::size_t threads : {2, 3}) {
    const auto shared = pack_randomly(wanted, {.threads = threads});
    ASSERT_TRUE(shared);
    EXPECT_EQ(shared->discs.x, alone->discs.x) << threads;
    EXPECT_EQ(shared->discs.y, alone->discs.y) << threads;
    EXPECT_EQ(shared->discs.radius, alone->discs.radius) << threads;
  }
}

// Sizes of 1 to 50 do not keep the packing from reaching its stress.
TEST(RandomPacking, TakesSizesOfOneToFifty) {
  const auto grown = pack_randomly({{0, 3, 0, 3}, 0.004, 0.2, 0.16, 1e-2, 3});
  ASSERT_TRUE(grown);
  EXPECT_NEAR((grown->state.stress_x + grown->state.stress_y) / 2, 1e-2, 1e-4);
}

// Two discs that a box presses: each wall pushes with its overlap, the discs push each other alike.
TEST(PressedDiscs, BalanceTheWallsOfANarrowBox) {
  protocol::Team team;
  PressedDiscs pressed({{0.5, 1.4}, {0.5, 0.5}, {0.5, 0.5}}, {0, 1.9, 0, 1}, team);
  ASSERT_TRUE(pressed.relax(1e-10, 100000));
  const double overlap = 0.1 / 3;  // 2 - 1.9 shared by three springs
  EXPECT_NEAR(pressed.discs().x[0], 0.5 - overlap, 1e-9);
  EXPECT_NEAR(pressed.wall_stress()[0], overlap, 1e-9);
  EXPECT_EQ(pressed.contacts().size(), 1u);
}

// A disc in the middle of a square of discs: 8 discs round the rim and one inside touch 12 times.
TEST(SquarePacking, FillsTheBoxWithTouchingDiscs) {
  const Discs discs = pack_squarely({0, 3.1, 0, 3}, 0.5);
  ASSERT_EQ(discs.size(), 9u);
  EXPECT_NEAR(discs.x[0], 0.55, 1e-15);
  EXPECT_NEAR(discs.y[8], 2.5, 1e-15);
  EXPECT_EQ(pairs_within(discs, 1e-9).size(), 12u);
  EXPECT_EQ(pairs_within(discs, std::numbers::sqrt2 - 1 + 1e-9).size(), 20u);  // the diagonals too
}

// A chain of discs on a triangle loses its links one after the other, the triangle stays.
TEST(Floaters, GoUntilNoneIsLeft) {
  const std::vector<Pair> contacts{{0, 1}, {0, 2}, {1, 2}, {2, 3}, {3, 4}};
  EXPECT_EQ(without_floaters(5, contacts, {}, 2), (std::vector<bool>{true, true, true, false, false}));
  const std::vector<std::uint32_t> walls{0, 0, 0, 0, 1};  // the wall holds the chain's end
  EXPECT_EQ(without_floaters(5, contacts, walls, 2), std::vector<bool>(5, true));
}

}  // namespace
}  // namespace adit::dem::random_packing_test

// Requirement: cracks that meet at their ends are one path, whose figures are those of its cracks; others are
// not.
#include "dem_server/observe/crack_paths.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace adit::dem::crack_paths_test {
namespace {

constexpr BondState kTensile = BondState::kTensileCrack, kShear = BondState::kShearCrack;

// Along x from (0, 0) to (3, 0), with a branch of one crack at (1, 0) and a crack by itself that comes near.
std::vector<ObservedCrack> fork() {
  return {{0, 1, 5, 4.01, 5, 4.02, 9e-3, 0, kShear},      {0, 2, 0, 0, 1, 0, 1e-3, 2e-4, kTensile},
          {0, 3, 2, 0, 1, 0, 3e-3, -6e-4, kTensile},      {0, 4, 2, 0, 3, 1e-9, 2e-3, 1e-4, kShear},
          {0, 5, 1, 1e-9, 1, 0.5, 5e-4, -1e-4, kTensile}, {0, 6, 1, 0.6, 1, 1, 0, 1e-4, kShear}};
}

TEST(CrackPaths, JoinWhatMeetsAtItsEnds) {
  const CrackPaths found = paths_of(fork());
  EXPECT_EQ(found.number, (std::vector<std::uint32_t>{3, 1, 1, 1, 1, 2}));
  ASSERT_EQ(found.paths.size(), 3u);
  const CrackPath& longest = found.paths[0];
  EXPECT_EQ(longest.cracks, 4u);
  EXPECT_EQ(longest.mode, kTensile);
  EXPECT_NEAR(longest.length, 3.5, 1e-8);
  EXPECT_EQ(longest.opening, 3e-3);
  EXPECT_EQ(longest.slip, 6e-4);
  EXPECT_EQ(longest.x, 1.5);
  EXPECT_EQ(longest.y, 0);
  EXPECT_NEAR(found.paths[1].length, 0.4, 1e-12);
  EXPECT_EQ(found.paths[1].opening, 0);
  EXPECT_EQ(found.paths[1].y, 0.8);
}

// The mode is that of most of the length, not of most cracks.
TEST(CrackPaths, HaveTheModeOfMostOfTheirLength) {
  std::vector<ObservedCrack> cracks{{0, 1, 0, 0, 1, 0, 0, 0, kShear},
                                    {0, 2, 1, 0, 1.2, 0, 0, 0, kTensile},
                                    {0, 3, 1.2, 0, 1.4, 0, 0, 0, kTensile}};
  EXPECT_EQ(paths_of(cracks).paths.at(0).mode, kShear);
  cracks[0].mode = kTensile;
  EXPECT_EQ(paths_of(cracks).paths.at(0).mode, kTensile);
}

// Whatever the order of the cracks: the same paths.
TEST(CrackPaths, DoNotDependOnTheOrderOfTheCracks) {
  std::vector<ObservedCrack> cracks = fork();
  std::mt19937 random(1);
  for (int turn = 0; turn < 20; ++turn) {
    std::ranges::shuffle(cracks, random);
    const CrackPaths found = paths_of(cracks);
    ASSERT_EQ(found.paths.size(), 3u);
    for (std::size_t k = 0; k < cracks.size(); ++k) {
      const bool joined = cracks[k].second >= 2 && cracks[k].second <= 5;
      EXPECT_EQ(found.number[k] == 1, joined) << cracks[k].second;
    }
    EXPECT_EQ(found.paths[0].x, 1.5);
  }
}

// Where a lining has left the ground, all around, its cracks are apart all the same.
TEST(CrackPaths, AreNotJoinedByWhatHasDebonded) {
  std::vector<ObservedCrack> cracks = fork();
  cracks[2].debonded = true;  // from (2, 0) to (1, 0)
  const CrackPaths found = paths_of(cracks);
  EXPECT_EQ(found.number, (std::vector<std::uint32_t>{4, 1, 0, 2, 1, 3}));
  ASSERT_EQ(found.paths.size(), 4u);
  EXPECT_NEAR(found.paths[0].length, 1.5, 1e-8);
  EXPECT_EQ(found.paths[0].opening, 1e-3);
}

TEST(CrackPaths, AreNoneWithoutCracks) {
  EXPECT_TRUE(paths_of({}).paths.empty());
}

}  // namespace
}  // namespace adit::dem::crack_paths_test

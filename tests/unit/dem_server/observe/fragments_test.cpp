#include "dem_server/observe/fragments.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "dem_server/packing/regular.hpp"

namespace adit::dem::fragments_test {
namespace {

std::vector<Pair> chain(std::uint32_t discs) {
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i + 1 < discs; ++i) pairs.push_back({i, i + 1});
  return pairs;
}

// What nothing holds is a fragment by itself; no discs are no fragments.
TEST(Fragments, LooseDiscsAreOneEach) {
  const Fragments loose = fragments_of(3, {});
  EXPECT_EQ(loose.number, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(loose.size, (std::vector<std::uint32_t>{1, 1, 1}));
  EXPECT_EQ(fragments_of(0, {}).count(), 0u);
}

// A ring holds when one bond breaks and falls in two with the second one.
TEST(Fragments, ARingFallsWithItsSecondBond) {
  auto pairs = chain(6);
  pairs.push_back({0, 5});
  EXPECT_EQ(fragments_of(6, pairs).count(), 1u);
  pairs.erase(pairs.begin() + 1);  // 1 - 2
  EXPECT_EQ(fragments_of(6, pairs).count(), 1u);
  pairs.erase(pairs.begin() + 3);  // 4 - 5
  const Fragments two = fragments_of(6, pairs);
  EXPECT_EQ(two.number, (std::vector<std::uint32_t>{0, 0, 1, 1, 1, 0}));
  EXPECT_EQ(two.size, (std::vector<std::uint32_t>{3, 3}));
}

// Two discs have the same number exactly where a walk along the pairs leads from one to the other, and
// numbers ascend with the lowest discs, whatever the order of the pairs.
RC_GTEST_PROP(Fragments, AreWhatAWalkReaches, ()) {
  const auto discs = *rc::gen::inRange<std::uint32_t>(1, 30);
  const auto end = rc::gen::inRange<std::uint32_t>(0, discs);
  auto pairs =
      *rc::gen::container<std::vector<Pair>>(rc::gen::map(rc::gen::pair(end, end), [](const auto& p) {
        return Pair{p.first, p.second};
      }));
  const Fragments fragments = fragments_of(discs, pairs);
  std::ranges::reverse(pairs);
  RC_ASSERT(fragments_of(discs, pairs).number == fragments.number);

  std::vector<std::uint32_t> number(discs, discs);
  std::uint32_t count = 0;
  for (std::uint32_t start = 0; start < discs; ++start) {
    if (number[start] != discs) continue;
    number[start] = count;
    for (bool grows = true; grows;) {
      grows = false;
      for (const Pair& p : pairs)
        if ((number[p.first] == count) != (number[p.second] == count)) {
          number[p.first] = number[p.second] = count;
          grows = true;
        }
    }
    RC_ASSERT(fragments.size[count] == std::ranges::count(number, count));
    ++count;
  }
  RC_ASSERT(fragments.number == number);
  RC_ASSERT(fragments.count() == count);
}

// A chain that hangs on a ring rolls up to the ring; where its last pair but one resists turning, only what
// is beyond rolls. A chain between two rings holds.
TEST(Fragments, WhatHangsOnASinglePairRolls) {
  const std::vector<Pair> ring = {{0, 1}, {1, 2}, {2, 0}}, tail = {{2, 3}, {3, 4}, {4, 5}};
  std::vector<HoldingPair> holding;
  for (const Pair& pair : ring) holding.push_back({pair, false});
  for (const Pair& pair : tail) holding.push_back({pair, false});
  EXPECT_EQ(without_rolling(6, holding), ring);
  holding[4].resists_turning = true;  // 3 - 4
  EXPECT_EQ(without_rolling(6, holding), (std::vector<Pair>{{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}}));
  holding[4].resists_turning = false;
  for (const Pair& pair : {Pair{5, 6}, Pair{6, 7}, Pair{7, 5}}) holding.push_back({pair, false});
  EXPECT_EQ(without_rolling(8, holding).size(), holding.size());
}

// In a hexagonal packing a disc has six neighbours, at an even edge four, at a corner two or three.
TEST(Coordination, OfAHexagonalPacking) {
  const Discs discs = pack_hexagonally({0, 10, 0, 9 * 0.8660254037844387}, 0.5).discs;
  const auto count = coordination_of(discs.size(), pairs_within(discs, 1e-6));
  EXPECT_EQ(count[0], 2u);       // corner
  EXPECT_EQ(count[5], 4u);       // bottom
  EXPECT_EQ(count[10 + 4], 6u);  // inside
  EXPECT_EQ(count[10], 5u);      // end of a short row
  EXPECT_EQ(count[19], 3u);      // end of a long row
}

}  // namespace
}  // namespace adit::dem::fragments_test

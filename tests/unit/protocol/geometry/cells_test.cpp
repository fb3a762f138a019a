#include "protocol/geometry/cells.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

namespace adit::protocol::cells_test {
namespace {

double coordinate() {
  return *rc::gen::inRange(-1000, 1000) / 100.0;
}

// Nothing that holds a point, or comes within reach of it, is missed.
RC_GTEST_PROP(Cells, MissNothing, ()) {
  std::vector<Extent> things(*rc::gen::inRange(1, 30));
  for (Extent& thing : things) {
    const double x = coordinate(), y = coordinate();
    thing = {x, x + *rc::gen::inRange(0, 300) / 100.0, y, y + *rc::gen::inRange(0, 300) / 100.0};
  }
  const Cells cells(things, *rc::gen::inRange(20, 500) / 100.0);
  const double x = coordinate(), y = coordinate(), reach = *rc::gen::inRange(0, 400) / 100.0;
  const auto here = cells.at(x, y);
  std::set<std::uint32_t> near;
  cells.visit_near(x, y, reach, [&](std::uint32_t thing) { near.insert(thing); });
  for (std::uint32_t i = 0; i < things.size(); ++i) {
    const Extent& t = things[i];
    const auto within = [&](double margin) {
      return x >= t.x_min - margin && x <= t.x_max + margin && y >= t.y_min - margin && y <= t.y_max + margin;
    };
    if (within(0)) RC_ASSERT(std::ranges::find(here, i) != here.end());
    if (within(reach)) RC_ASSERT(near.contains(i));
  }
}

// A place far outside, or among no things, is an answer and not a crash.
TEST(Cells, PlacesOutsideAreHarmless) {
  EXPECT_TRUE(Cells().at(3, 4).empty());
  EXPECT_TRUE(Cells({}, 1.0).at(3, 4).empty());
  const std::vector<Extent> one{{0, 1, 0, 1}};
  EXPECT_NO_THROW(Cells(one, 1.0).at(-1e300, 1e300));
}

}  // namespace
}  // namespace adit::protocol::cells_test

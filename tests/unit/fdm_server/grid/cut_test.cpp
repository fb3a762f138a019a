// Requirements on cuts through a grid.
#include "fdm_server/grid/cut.hpp"

#include <gtest/gtest.h>

#include <set>

namespace adit::fdm::test::cut_test {
namespace {

// Four by four zones; point (i, j) is 5 j + i.
Grid block() {
  return make_grid({0, 4, 0, 4, 4, 4});
}
std::uint32_t point(std::uint32_t i, std::uint32_t j) {
  return 5 * j + i;
}
std::vector<Side> level(std::uint32_t from, std::uint32_t to, std::uint32_t j) {
  std::vector<Side> sides;
  for (std::uint32_t i = from; i < to; ++i) sides.push_back({point(i, j), point(i + 1, j)});
  return sides;
}
std::vector<Side> upright(std::uint32_t from, std::uint32_t to, std::uint32_t i) {
  std::vector<Side> sides;
  for (std::uint32_t j = from; j < to; ++j) sides.push_back({point(i, j), point(i, j + 1)});
  return sides;
}
Grid cut_along(std::vector<Side> sides, const std::vector<Side>& more = {}) {
  Grid grid = block();
  sides.insert(sides.end(), more.begin(), more.end());
  cut(grid, sides, std::vector<bool>(grid.x.size(), false));
  return grid;
}
std::size_t copies(const Grid& grid, std::uint32_t of) {
  std::set<std::int32_t> found;
  for (const auto& zone : grid.zones)
    for (const auto corner : zone)
      if (grid.place(static_cast<std::uint32_t>(corner)) == of) found.insert(corner);
  return found.size();
}

// From side to side all points of a cut are doubled; an end inside stays one.
TEST(Cut, DoublesItsPointsButAnEndInside) {
  const Grid through = cut_along(level(0, 4, 2));
  for (std::uint32_t i = 0; i <= 4; ++i) EXPECT_EQ(copies(through, point(i, 2)), 2);
  EXPECT_EQ(through.double_of.size(), 5);
  const Grid crack = cut_along(level(0, 2, 2));
  EXPECT_EQ(copies(crack, point(1, 2)), 2);
  EXPECT_EQ(copies(crack, point(2, 2)), 1);
  EXPECT_EQ(crack.double_of.size(), 2);
}

// Where cuts meet and cross there are as many points as corners that they part.
TEST(Cut, MayMeetAndCross) {
  EXPECT_EQ(copies(cut_along(level(0, 4, 2), upright(2, 4, 2)), point(2, 2)), 3);
  EXPECT_EQ(copies(cut_along(level(0, 4, 2), upright(0, 4, 2)), point(2, 2)), 4);
  EXPECT_EQ(copies(cut_along(level(1, 3, 2), upright(1, 3, 2)), point(2, 2)), 4);
}

// A ring of cuts frees what is inside.
TEST(Cut, MayClose) {
  std::vector<Side> ring = level(1, 3, 1);
  for (const auto& sides : {level(1, 3, 3), upright(1, 3, 1), upright(1, 3, 3)})
    ring.insert(ring.end(), sides.begin(), sides.end());
  EXPECT_EQ(cut_along(ring).double_of.size(), 8);
}

// Zones keep their shapes, the boundary stays that of the whole grid, and welded they are what they were.
TEST(Cut, MovesNothing) {
  const Grid whole = block(), parted = cut_along(level(0, 4, 2), upright(0, 4, 2));
  for (std::size_t z = 0; z < whole.zones.size(); ++z) {
    EXPECT_EQ(corners(parted, z).x, corners(whole, z).x);
    EXPECT_EQ(corners(parted, z).y, corners(whole, z).y);
  }
  ASSERT_EQ(parted.boundary.size(), whole.boundary.size());
  for (std::size_t k = 0; k < whole.boundary.size(); ++k) {
    const auto& zone = parted.zones[parted.boundary[k].zone];
    for (const auto end : {parted.boundary[k].from, parted.boundary[k].to})
      EXPECT_NE(std::ranges::find(zone, end), zone.end());
  }
  EXPECT_EQ(welded(parted).zones, whole.zones);
}

TEST(Cut, LeavesWholeWhatIsKept) {
  Grid grid = block();
  std::vector<bool> kept(grid.x.size(), false);
  kept[point(0, 2)] = true;
  cut(grid, level(0, 4, 2), kept);
  EXPECT_EQ(copies(grid, point(0, 2)), 1);
  EXPECT_EQ(copies(grid, point(1, 2)), 2);
}

}  // namespace
}  // namespace adit::fdm::test::cut_test

// Requirements on what an area selects of a grid.
#include "fdm_server/model/grid/selection.hpp"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>

#include "tests/support/refusals.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"

namespace adit::fdm::test::selection_test {
namespace {

using testing::ElementsAre;

// 4 x 2 zones of 1 m; `left` is the left half, `line` the two edges in the middle.
Grid grid_with_groups() {
  Grid grid = make_grid({0, 4, 0, 2, 4, 2});
  grid.groups.push_back({"left", {0, 1, 4, 5}, {}});
  grid.groups.push_back({"line", {}, {{2, 7, 1}, {7, 12, 5}}});
  return grid;
}

scene::Area area_of(const std::string& text) {
  scene::Area area;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &area)) << text;
  return area;
}

double length(const std::vector<Edge>& edges, const Grid& grid) {
  double sum = 0;
  for (const auto& [from, to, zone] : edges)
    sum += std::hypot(grid.x[to] - grid.x[from], grid.y[to] - grid.y[from]);
  return sum;
}

TEST(GridSelection, ZonesAreSelectedByTheirCentres) {
  const Grid grid = grid_with_groups();
  EXPECT_THAT(select_zones(grid, area_of("x_max: 1.4"), "where"), ElementsAre(0, 4));
  EXPECT_THAT(select_zones(grid, area_of("group: 'left' y_min: 1"), "where"), ElementsAre(4, 5));
}

TEST(GridSelection, AGroupSelectsThePointsOfItsZonesAndEdges) {
  const Grid grid = grid_with_groups();
  EXPECT_THAT(select_points(grid, area_of("group: 'left' y_max: 0"), "where"), ElementsAre(0, 1, 2));
  EXPECT_THAT(select_points(grid, area_of("group: 'line'"), "where"), ElementsAre(2, 7, 12));
}

// Boundary edges: the whole outline without a group, the outline of a group's zones, the edges of a line.
TEST(GridSelection, EdgesOfTheBoundaryAndOfGroups) {
  const Grid grid = grid_with_groups();
  EXPECT_DOUBLE_EQ(length(select_edges(grid, area_of(""), "where"), grid), 12);
  EXPECT_DOUBLE_EQ(length(select_edges(grid, area_of("group: 'left'"), "where"), grid), 6);
  EXPECT_DOUBLE_EQ(length(select_edges(grid, area_of("group: 'line' y_max: 1"), "where"), grid), 1);
}

// Zones that vanish take their part of groups and boundary with them; what is left keeps its names.
TEST(GridSelection, GroupsOutliveZonesThatVanish) {
  Grid grid = grid_with_groups();
  std::vector<double> weights{0, 1, 1, 1, 0, 1, 1, 1};
  compact(grid, weights);
  EXPECT_THAT(select_zones(grid, area_of("group: 'left'"), "where"), ElementsAre(0, 3));
  EXPECT_DOUBLE_EQ(length(select_edges(grid, area_of(""), "where"), grid), 8);  // not the edges laid bare
  EXPECT_DOUBLE_EQ(length(select_edges(grid, area_of("group: 'line'"), "where"), grid), 2);
}

void expect_refused(const Grid& grid, const std::string& area, const std::string& path,
                    const std::string& message) {
  adit::test::expect_refusal([&] { select_points(grid, area_of(area), "continuum.motions[0].where"); },
                             "continuum.motions[0].where" + path, message);
}

TEST(GridSelection, AnUnknownGroupIsRefusedWithTheNearestName) {
  expect_refused(grid_with_groups(), "group: 'lfet'", ".group",
                 "is `lfet`, but the continuum has only the groups `left`, `line`; did you mean `left`?");
  expect_refused(make_grid({0, 4, 0, 2, 4, 2}), "group: 'lining'", ".group", "the continuum has no groups");
  expect_refused(grid_with_groups(), "group: 'left' x_min: 3", "", "selects no grid points");
}

}  // namespace
}  // namespace adit::fdm::test::selection_test

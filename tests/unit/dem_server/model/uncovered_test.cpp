// Lines end where something else takes the place of what they bound.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dem_server/model/placement/cells.hpp"
#include "dem_server/model/placement/uncovered.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::uncovered_test {
namespace {

using geometry::Point;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr double kReach = 1e-7;  // [m]

MATCHER_P2(IsNear, x, y, "") {
  return std::hypot(arg.x - x, arg.y - y) < kReach;
}

scene::Area circle(double radius) {
  scene::Area area;
  test::set(*area.mutable_circle()->mutable_centre(), 0, 0);
  area.mutable_circle()->set_radius(radius);
  return area;
}

std::vector<Cover> round_cover(double radius) {
  return {{protocol::Places(circle(radius), "where", -kReach), {FaceCircle{{0, 0}, radius}}}};
}

// A line through a circle of radius 5 is left outside it, with exact ends: (3, 4) by Pythagoras.
TEST(Uncovered, ALineEndsOnTheOutlineThatItEnters) {
  const auto parts = uncovered({{{3, -9}, {3, 9}}}, round_cover(5), kReach);
  ASSERT_THAT(parts, SizeIs(2));
  EXPECT_THAT(parts[0].corners, ElementsAre(IsNear(3, -9), IsNear(3, -4)));
  EXPECT_THAT(parts[1].corners, ElementsAre(IsNear(3, 4), IsNear(3, 9)));
}

// A closed line that begins outside the circle goes on through its own beginning.
TEST(Uncovered, APartOfAClosedLineGoesOnThroughItsFirstCorner) {
  const auto parts = uncovered({{{9, 4}, {-9, 4}, {-9, 20}, {9, 20}}, true}, round_cover(5), kReach);
  ASSERT_THAT(parts, SizeIs(1));
  EXPECT_FALSE(parts[0].closed);
  EXPECT_THAT(parts[0].corners, ElementsAre(IsNear(-3, 4), IsNear(-9, 4), IsNear(-9, 20), IsNear(9, 20),
                                            IsNear(9, 4), IsNear(3, 4)));
}

// What lies outside stays as it is; what lies inside goes.
TEST(Uncovered, ALineIsKeptWholeOrGoes) {
  const FaceLine square{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, true};
  const auto kept = uncovered(square, round_cover(0.5), kReach);
  ASSERT_THAT(kept, SizeIs(1));
  EXPECT_TRUE(kept[0].closed);
  EXPECT_THAT(uncovered(square, round_cover(2), kReach), IsEmpty());
}

// Where a band of gouge grazes a lining, at 34 degrees on the inner face, the cells of the lining end on both
// of its faces all around, to the sagitta of the chords of a circle: size^2 / (8 radius) = 0.003 size.
TEST(Uncovered, ALiningIsExactWhereGougeGrazesIt) {
  constexpr double kInner = 4.4, kOuter = 5, kSize = 0.12;
  scene::Particles particles;
  auto& cells = *particles.mutable_cells();
  for (const auto set : {&scene::CellPacking::set_x_max, &scene::CellPacking::set_y_max}) (cells.*set)(7);
  for (const auto set : {&scene::CellPacking::set_x_min, &scene::CellPacking::set_y_min}) (cells.*set)(-7);
  cells.set_size(kSize);
  auto& band = *particles.add_groups()->mutable_where()->mutable_band();
  test::set(*band.mutable_from(), -7.5, -17.32);
  test::set(*band.mutable_to(), 12.5, 17.32);
  band.set_width(3);
  auto& lining = *particles.add_groups()->mutable_where()->mutable_annulus();
  test::set(*lining.mutable_centre(), 0, 0);
  lining.set_inner_radius(kInner);
  lining.set_outer_radius(kOuter);
  auto& excavation = *particles.add_excavations();
  *excavation.mutable_where() = circle(kOuter);
  excavation.set_stage(1);

  const Placement placement = place_cells(particles);
  double nearest = kOuter, farthest = kInner;
  for (std::size_t i = 0; i < placement.discs.size(); ++i) {
    const double radius = std::hypot(placement.discs.x[i], placement.discs.y[i]);
    if (radius < kInner || radius > kOuter) continue;
    for (const Point& corner : placement.cells->outlines[i]) {
      const double at = std::hypot(placement.discs.x[i] + corner.x, placement.discs.y[i] + corner.y);
      nearest = std::min(nearest, at);
      farthest = std::max(farthest, at);
    }
  }
  EXPECT_NEAR(nearest, kInner, 0.01 * kSize);
  EXPECT_NEAR(farthest, kOuter, 0.01 * kSize);
}

}  // namespace
}  // namespace adit::dem::uncovered_test

// Distances to shapes: closed forms, and dense points where there are none.
#include "protocol/geometry/shape.hpp"

#include <algorithm>
#include <limits>

#include "protocol/geometry/polygon.hpp"
#include "protocol/geometry/read_shape.hpp"
#include "tests/unit/coupler/bridging/random_overlaps.hpp"

namespace adit::geometry::shape_test {
namespace {

scene::Shape parse(const std::string& text) {
  scene::Shape shape;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &shape)) << text;
  return shape;
}

std::shared_ptr<const Shape> shape_of(const std::string& text) {
  return read_shape(parse(text), "around");
}

// Requirement: beside a side the distance is that to the side, beyond a corner that to the corner.
TEST(Shape, DistanceToABoxIsEuclidean) {
  const auto shape = shape_of(test::box(1, 3, 1, 5));
  EXPECT_DOUBLE_EQ(shape->distance(7, 2), 4);
  EXPECT_DOUBLE_EQ(shape->distance(6, 9), 5);  // 3, 4 beyond the corner
  EXPECT_DOUBLE_EQ(shape->distance(1.5, 3), -0.5);
  EXPECT_EQ(shape->distance(3, 4), 0);
}

TEST(Shape, DistanceToACircle) {
  const auto shape = shape_of(test::circle(1, 2, 3));
  EXPECT_DOUBLE_EQ(shape->distance(4, 6), 2);
  EXPECT_DOUBLE_EQ(shape->distance(1, 4), -1);
}

// Requirement: an annulus answers as the plane between its circles does.
TEST(Shape, AnAnnulusHasAHole) {
  const auto shape = annulus(1, 2, 3, 5);
  EXPECT_DOUBLE_EQ(shape->distance(1, 2), 3);
  EXPECT_DOUBLE_EQ(shape->distance(1, 8), 1);
  EXPECT_DOUBLE_EQ(shape->distance(5, 2), -1);
  EXPECT_DOUBLE_EQ(shape->distance({0, 2, 1, 3}), 3 - std::sqrt(2));  // a box in the hole
  EXPECT_DOUBLE_EQ(shape->distance({0, 5, 1, 3}), 0);
  EXPECT_DOUBLE_EQ(shape->distance({8, 9, 1, 3}), 2);
  EXPECT_TRUE(shape->covers({4.5, 5, 1.5, 2.5}));
  EXPECT_FALSE(shape->covers({-2, 4, -1, 5}));  // its corners lie between the circles, its middle in the hole
  EXPECT_EQ(shape->box_around(1).x_max, 7);
}

// Requirement: a hole is outside, and the order of the corners does not matter.
TEST(Shape, AHoleIsOutside) {
  const std::string outer =
      "corners { x: 0 y: 0 } corners { x: 9 y: 0 } corners { x: 9 y: 9 } corners { x: 0 y: 9 }";
  for (const std::string hole :
       {"corners { x: 3 y: 3 } corners { x: 6 y: 3 } corners { x: 6 y: 6 } corners { x: 3 y: 6 }",
        "corners { x: 3 y: 3 } corners { x: 3 y: 6 } corners { x: 6 y: 6 } corners { x: 6 y: 3 }"}) {
    const auto shape = shape_of("polygon { " + outer + " holes { " + hole + " } }");
    EXPECT_DOUBLE_EQ(shape->distance(4, 4.5), 1);
    EXPECT_DOUBLE_EQ(shape->distance(2, 4.5), -1);
    EXPECT_DOUBLE_EQ(shape->distance(-2, 4.5), 2);
    EXPECT_FALSE(shape->covers({1, 8, 1, 8}));
    EXPECT_TRUE(shape->covers({0, 9, 0, 3}));
    EXPECT_DOUBLE_EQ(shape->distance({4, 5, 4, 5}), 1);
  }
}

// Requirement: a regular polygon of n corners lies between its two circles.
RC_GTEST_PROP(Shape, ManyCornersMakeACircle, ()) {
  const int n = *rc::gen::inRange(5, 60);
  const double radius = test::random_between(0.5, 2), x = test::random_between(-4, 4),
               y = test::random_between(-4, 4);
  const auto polygon = shape_of("polygon { " + test::star(0.3, -0.2, radius, n, 0.1, 1) + "}");
  const auto outer = disc(0.3, -0.2, radius),
             inner = disc(0.3, -0.2, radius * std::cos(std::numbers::pi / n));
  const double d = polygon->distance(x, y);
  RC_ASSERT(outer->distance(x, y) <= d + 1e-12);
  RC_ASSERT(d <= inner->distance(x, y) + 1e-12);
}

// Requirement: from one point to another the signed distance changes by no more than the way between; it does
// change by more wherever the sign is wrong.
RC_GTEST_PROP(Shape, DistanceChangesNoFasterThanThePlace, ()) {
  const auto shape = shape_of(test::random_shape());
  const double x = test::random_between(-2, 2), y = test::random_between(-2, 2);
  const double dx = test::random_between(-0.1, 0.1), dy = test::random_between(-0.1, 0.1);
  RC_ASSERT(std::abs(shape->distance(x + dx, y + dy) - shape->distance(x, y)) <= std::hypot(dx, dy) + 1e-12);
}

// Requirement: what a box is to a shape, its points are.
RC_GTEST_PROP(Shape, ABoxIsWhatItsPointsAre, ()) {
  const auto shape = shape_of(test::random_shape());
  const double x = test::random_between(-2, 2), y = test::random_between(-2, 2);
  const BoundingBox box{x, x + test::random_between(0.01, 1), y, y + test::random_between(0.01, 1)};
  constexpr int kPoints = 100;
  double nearest = std::numeric_limits<double>::infinity(), furthest = -nearest;
  for (int i = 0; i <= kPoints; ++i)
    for (int j = 0; j <= kPoints; ++j) {
      const double d = shape->distance(std::lerp(box.x_min, box.x_max, i / double{kPoints}),
                                       std::lerp(box.y_min, box.y_max, j / double{kPoints}));
      nearest = std::min(nearest, d);
      furthest = std::max(furthest, d);
    }
  const double spacing = std::hypot(box.x_max - box.x_min, box.y_max - box.y_min) / kPoints;
  RC_ASSERT(shape->distance(box) <= std::max(nearest, 0.0) + 1e-12);
  RC_ASSERT(shape->distance(box) >= std::max(nearest, 0.0) - spacing);
  if (furthest > 0) RC_ASSERT(!shape->covers(box));
  if (furthest < -spacing) RC_ASSERT(shape->covers(box));
}

TEST(Loop, IsSimpleIfItsSidesMeetInCornersOnly) {
  EXPECT_TRUE(is_simple({{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
  EXPECT_TRUE(is_simple({{0, 0}, {1, 0}, {2, 0}, {2, 2}}));                   // a corner on a straight side
  EXPECT_FALSE(is_simple({{0, 0}, {2, 0}}));                                  // no area
  EXPECT_FALSE(is_simple({{0, 0}, {1, 0}, {2, 0}}));                          // no area
  EXPECT_FALSE(is_simple({{0, 0}, {2, 2}, {2, 0}, {0, 2}}));                  // a bow tie
  EXPECT_FALSE(is_simple({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}));          // touches its own side
  EXPECT_FALSE(is_simple({{0, 0}, {2, 0}, {4, 0}, {2, 0}, {2, 2}}));          // runs back
  EXPECT_FALSE(is_simple({{0, 0}, {2, 0}, {2, 0}, {0, 2}}));                  // a corner twice
  EXPECT_FALSE(is_simple({{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}));  // two triangles at one corner
}

}  // namespace
}  // namespace adit::geometry::shape_test

// Requirements on areas: what they hold, and what they say where they hold nothing.
#include "protocol/geometry/selection.hpp"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>

#include <vector>

#include "tests/support/refusals.hpp"

namespace adit::protocol::selection_test {
namespace {

using ::testing::ElementsAre;

const std::vector<double> kPoints{0, 0, 1, 0, 2, 0, 2, 5};  // (0,0) (1,0) (2,0) (2,5)

scene::Area area_of(const std::string& text) {
  scene::Area area;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &area)) << text;
  return area;
}

std::vector<std::uint32_t> selected(const std::string& area, double tolerance = 0) {
  return select(area_of(area), kPoints, tolerance, "particles.loads[0].where", "particles");
}

void expect_refused(const std::string& area, const std::string& path, const std::string& message) {
  adit::test::expect_refusal([&] { selected(area); }, "particles.loads[0].where" + path, message);
}

TEST(Selection, PointsOnTheEdgeOfTheBoxAreInside) {
  EXPECT_THAT(selected("x_min: 1 x_max: 2 y_min: 0 y_max: 0"), ElementsAre(1, 2));
}

TEST(Selection, ASideThatIsLeftOutIsUnbounded) {
  EXPECT_THAT(selected(""), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(selected("x_min: 1.5"), ElementsAre(2, 3));
  EXPECT_THAT(selected("x_min: 1.5 y_max: 1"), ElementsAre(2));
}

TEST(Selection, TheToleranceWidensEverySide) {
  for (const double tolerance : {0.05, 0.15}) {
    const Places box(area_of("x_min: 0 x_max: 1 y_min: 0 y_max: 1"), "where", tolerance);
    const Places circle(area_of("circle { centre { x: 0.5 y: 0.5 } radius: 0.5 }"), "where", tolerance);
    const Places annulus(area_of("annulus { centre { x: 0.5 y: 0.5 } inner_radius: 0.2 outer_radius: 0.5 }"),
                         "where", tolerance);
    const Places band(area_of("band { from { x: 0 y: 0.5 } to { x: 1 y: 0.5 } width: 1 }"), "where",
                      tolerance);
    EXPECT_EQ(annulus.hold(0.5, 0.6), tolerance > 0.1);
    for (const auto& [x, y] :
         {std::pair(-0.1, 0.5), std::pair(1.1, 0.5), std::pair(0.5, -0.1), std::pair(0.5, 1.1)}) {
      EXPECT_EQ(box.hold(x, y), tolerance > 0.1);
      EXPECT_EQ(circle.hold(x, y), tolerance > 0.1);
      EXPECT_EQ(annulus.hold(x, y), tolerance > 0.1);
      EXPECT_EQ(band.hold(x, y), tolerance > 0.1);
    }
  }
}

TEST(Selection, ACircleHoldsItsRim) {
  EXPECT_THAT(selected("circle { centre { x: 1 y: 0 } radius: 1 }"), ElementsAre(0, 1, 2));
}

// Requirement: an annulus holds both its circles and what lies between them, and nothing of its hole.
TEST(Selection, AnAnnulusHoldsBothItsCircles) {
  const std::string ring = "annulus { centre { x: 0 y: 0 } inner_radius: 1 outer_radius: 2 }";
  EXPECT_THAT(selected(ring), ElementsAre(1, 2));
  const Places places(area_of("annulus { centre { x: 1 y: 2 } inner_radius: 5 outer_radius: 10 }"), "where",
                      0);
  EXPECT_TRUE(places.hold(1 + 3, 2 + 4));  // 5 from the centre
  EXPECT_TRUE(places.hold(1 - 6, 2 + 8));  // 10
  EXPECT_FALSE(places.hold(1 + 3, 2 + 3.9));
  EXPECT_FALSE(places.hold(1 - 6, 2 + 8.1));
  EXPECT_FALSE(places.hold(1, 2));
}

// Requirement: a band holds what lies within half its width of the line, its border included, and ends
// square.
TEST(Selection, ABandHoldsWhatLiesWithinHalfItsWidth) {
  const Places level(area_of("band { from { x: 1 y: 2 } to { x: 5 y: 2 } width: 2 }"), "where", 0);
  EXPECT_TRUE(level.hold(1, 1));
  EXPECT_TRUE(level.hold(5, 3));
  EXPECT_FALSE(level.hold(5.1, 2));
  EXPECT_FALSE(level.hold(3, 3.1));
  // Along (3, 4) / 5 from the origin, 10 long and 5 wide: the corner beside its end is (6, 8) + (-2, 1.5).
  const Places sloping(area_of("band { from { x: 0 y: 0 } to { x: 6 y: 8 } width: 5 }"), "where", 1e-12);
  EXPECT_TRUE(sloping.hold(4, 9.5));
  EXPECT_TRUE(sloping.hold(-2, 1.5));
  EXPECT_FALSE(sloping.hold(4 - 0.008, 9.5 + 0.006));  // 1 cm beside the border
  EXPECT_FALSE(sloping.hold(4 + 0.006, 9.5 + 0.008));  // 1 cm beyond the end
}

TEST(Selection, ABandWithoutLengthIsRefused) {
  expect_refused("band { from { x: 1 y: 1 } to { x: 1 y: 1 } width: 2 }", ".band.to",
                 "is the same place as `from`; give a band two ends");
}

TEST(Selection, APolygonHoldsWhatLiesOutsideItsHoles) {
  EXPECT_THAT(
      selected("polygon { corners { x: -1 y: -1 } corners { x: 3 y: -1 } corners { x: 3 y: 1 } corners { "
               "x: -1 y: 1 } holes { corners { x: 0.5 y: -0.5 } corners { x: 1.5 y: -0.5 } corners { x: "
               "1.5 y: 0.5 } corners { x: 0.5 y: 0.5 } } }"),
      ElementsAre(0, 2));
}

TEST(Selection, WhatIsGivenTogetherMustAllHold) {
  EXPECT_THAT(selected("circle { centre { x: 1 y: 0 } radius: 1 } x_min: 0.5"), ElementsAre(1, 2));
}

TEST(Selection, SelectingNothingNamesThePathAndThePoints) {
  expect_refused("x_min: 3", "", "selects no particles; widen it so that it holds at least one");
}

TEST(Selection, APolygonThatCrossesItselfIsRefused) {
  expect_refused(
      "polygon { corners { x: 0 y: 0 } corners { x: 2 y: 2 } corners { x: 2 y: 0 } corners { x: 0 y: 2 } }",
      ".polygon.corners", "cross");
}

TEST(Selection, AGroupNeedsAModelThatHasGroups) {
  expect_refused("group: 'lining'", ".group", "particles have no groups; select them by place");
}

}  // namespace
}  // namespace adit::protocol::selection_test

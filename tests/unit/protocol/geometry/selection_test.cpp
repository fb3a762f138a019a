// Requirements on areas: what they hold, and what they say where they hold nothing.
#include "protocol/geometry/selection.hpp"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>

#include <vector>

#include "tests/support/refusals.hpp"

namespace adit::protocol {
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
    for (const auto& [x, y] :
         {std::pair(-0.1, 0.5), std::pair(1.1, 0.5), std::pair(0.5, -0.1), std::pair(0.5, 1.1)}) {
      EXPECT_EQ(box.hold(x, y), tolerance > 0.1);
      EXPECT_EQ(circle.hold(x, y), tolerance > 0.1);
    }
  }
}

TEST(Selection, ACircleHoldsItsRim) {
  EXPECT_THAT(selected("circle { centre { x: 1 y: 0 } radius: 1 }"), ElementsAre(0, 1, 2));
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
}  // namespace adit::protocol

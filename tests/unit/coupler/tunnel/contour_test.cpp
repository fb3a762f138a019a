// The outlines of tunnels: what lies inside them, and cuts at right angles to them.
#include "coupler/tunnel/contour.hpp"

#include <cmath>
#include <numbers>

#include "protocol/geometry/selection.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/coupler/tunnel/tunnels.hpp"

namespace adit::coupler::contour_test {
namespace {

using std::numbers::pi;

Contour contour(const std::string& shape) {
  return {test::tunnel_of("centre { x: 1 y: 2 } " + shape), "tunnels[0]"};
}

bool holds(const scene::Area& area, double x, double y) {
  return protocol::Places(area, "where", 1e-12).hold(x, y);
}

void expect_cut(const Contour::Cut& cut, double x, double y, double nx, double ny) {
  EXPECT_NEAR(cut.place.x, x, 1e-12);
  EXPECT_NEAR(cut.place.y, y, 1e-12);
  EXPECT_NEAR(cut.nx, nx, 1e-12);
  EXPECT_NEAR(cut.ny, ny, 1e-12);
}

TEST(Contour, ACircle) {
  const Contour circle = contour("circle { radius: 3 }");
  EXPECT_TRUE(holds(circle.inside(1), 5, 2));
  EXPECT_FALSE(holds(circle.inside(1), 5.01, 2));
  EXPECT_TRUE(holds(circle.between(0.5, 1), 1, 5.5));
  EXPECT_FALSE(holds(circle.between(0.5, 1), 1, 5.49));
  EXPECT_EQ(circle.shape(1).circle().radius(), 4);
  expect_cut(circle.cut(0.25), 1, 5, 0, 1);
  expect_cut(circle.cut_at_angle(pi), -2, 2, -1, 0);
  EXPECT_NEAR(circle.cut(0).at(0.5).x, 4.5, 1e-12);
}

// A width of 6 m and a height of 5 m: the arch of 3 m stands on walls of 2 m.
TEST(Contour, AHorseshoe) {
  const Contour horseshoe = contour("horseshoe { width: 6 height: 5 }");
  EXPECT_TRUE(holds(horseshoe.inside(0), 1, 5));
  EXPECT_FALSE(holds(horseshoe.inside(0), 1, 5.01));
  EXPECT_FALSE(holds(horseshoe.inside(0), 3.3, 4.3));  // beyond the arch, within the box around it
  EXPECT_TRUE(holds(horseshoe.inside(0), 4, 0));       // the lower right corner
  EXPECT_FALSE(holds(horseshoe.inside(0), 4, -0.01));
  EXPECT_TRUE(holds(horseshoe.between(0, 0.5), 4.5, -0.5));
  EXPECT_FALSE(holds(horseshoe.between(0, 0.5), 1, 2));
  const double length = 3 * pi + 2 * 2 + 6;
  expect_cut(horseshoe.cut(0), 4, 2, 1, 0);
  expect_cut(horseshoe.cut(1.5 * pi / length), 1, 5, 0, 1);
  expect_cut(horseshoe.cut((3 * pi + 1) / length), -2, 1, -1, 0);
  expect_cut(horseshoe.cut((3 * pi + 2 + 3) / length), 1, 0, 0, -1);
  expect_cut(horseshoe.cut((3 * pi + 2 + 6 + 1) / length), 4, 1, 1, 0);
}

TEST(Contour, ABox) {
  const Contour box = contour("box { width: 8 height: 4 }");
  EXPECT_TRUE(holds(box.inside(0.5), 5.5, 4.5));
  EXPECT_FALSE(holds(box.inside(0.5), 5.5, 4.51));
  EXPECT_FALSE(holds(box.between(0, 0.5), 4.9, 3.9));
  EXPECT_TRUE(holds(box.between(0, 0.5), 5.2, 3.9));
  expect_cut(box.cut(1 / 24.0), 5, 3, 1, 0);
  expect_cut(box.cut(6 / 24.0), 1, 4, 0, 1);
  expect_cut(box.cut(12 / 24.0), -3, 2, -1, 0);
  expect_cut(box.cut(18 / 24.0), 1, 0, 0, -1);
  expect_cut(box.cut(23 / 24.0), 5, 1, 1, 0);
}

// Requirement: the polygon of an arch stays within a thousandth of its radius.
TEST(Contour, TheArchIsRound) {
  const auto corners = contour("horseshoe { width: 6 height: 5 }").shape(1).polygon().corners();
  for (int k = 1; k + 2 < corners.size(); ++k) {
    const double x = (corners[k].x() + corners[k + 1].x()) / 2 - 1,
                 y = (corners[k].y() + corners[k + 1].y()) / 2 - 2;
    EXPECT_NEAR(std::hypot(x, y), 4, 4e-3);
  }
}

TEST(Contour, WhatIsNoOutlineIsRefused) {
  test::expect_refusal([] { contour(""); }, "tunnels[0]",
                       "has no shape; give a circle, a horseshoe or a box");
  test::expect_refusal([] { contour("horseshoe { width: 6 height: 3 }"); }, "tunnels[0].horseshoe.height",
                       "is 3 m, but the arch over a width of 6 m is 3 m high alone");
}

}  // namespace
}  // namespace adit::coupler::contour_test

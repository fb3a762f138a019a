// Impossible overlaps, and overlaps outside their models, are refused in one sentence that names the field.
#include <gmock/gmock.h>

#include "coupler/bridging/overlap_checks.hpp"
#include "protocol/scene/fields/check_rules.hpp"
#include "tests/support/overlaps.hpp"
#include "tests/support/refusals.hpp"

namespace adit::coupler {
namespace {

void expect_refused(const std::string& overlap, const std::string& path, const std::string& text) {
  const scene::Interface interface = test::interface_of("overlap { " + overlap + " }");
  test::expect_refusal(
      [&] {
        protocol::check_rules(interface, "interfaces[1]");
        Overlap(interface, "interfaces[1]");
      },
      "interfaces[1].overlap" + path, text);
}

TEST(OverlapErrors, StripOrRingButOneOfThem) {
  expect_refused("", "", "neither a strip nor a ring");
  expect_refused(test::strip(0, 0, 1, 0) + " width: 1", "", "a strip and a ring at once");
  expect_refused(test::strip(0, 0, 1, 0) + test::ring(test::circle(0, 0, 1), 1), "",
                 "a strip and a ring at once");
}

TEST(OverlapErrors, WhatIsMissing) {
  expect_refused("particles_begin { x: 0 y: 0 }", ".continuum_ends", "is missing");
  expect_refused("continuum_ends { x: 0 y: 0 }", ".particles_begin", "is missing");
  expect_refused("around { " + test::circle(0, 0, 1) + " }", ".width", "is missing");
  expect_refused("width: 1", ".around", "is missing");
  expect_refused("around { } width: 1", ".around", "no shape");
}

TEST(OverlapErrors, AStripWithoutWidth) {
  expect_refused(test::strip(4, 1, 4, 1), "", "has no width");
  expect_refused("particles_begin { x: nan y: 0 } continuum_ends { x: 1 y: 0 }", ".particles_begin.x",
                 "is not a number, expected a length");
}

TEST(OverlapErrors, ABoxWithoutFourSidesInOrder) {
  expect_refused("around { box { x_min: 0 x_max: 1 y_min: 0 } } width: 1", ".around.box.y_max",
                 "is missing; write for example `y_max: 2 m`");
  expect_refused(test::ring(test::box(2, 1, 0, 1), 1), ".around.box.x_max",
                 "is 1 m, expected a length above `x_min` = 2 m");
  expect_refused(test::ring(test::box(0, 1, 0, 0), 1), ".around.box.y_max",
                 "is 0 m, expected a length above `y_min` = 0 m");
}

std::string corners(const std::vector<std::pair<double, double>>& points) {
  std::string text;
  for (const auto& [x, y] : points) text += "corners " + test::point(x, y) + " ";
  return text;
}

void expect_refused_polygon(const std::string& polygon, const std::string& path, const std::string& text) {
  expect_refused(test::ring("polygon { " + polygon + " }", 1), ".around.polygon" + path, text);
}

TEST(OverlapErrors, APolygonThatEnclosesNoAreaOrMeetsItself) {
  expect_refused_polygon(corners({{0, 0}, {1, 0}}), ".corners", "has 2 elements, expected at least 3");
  expect_refused_polygon(corners({{0, 0}, {1, 1}, {2, 2}}), ".corners", "run back");
  expect_refused_polygon(corners({{0, 0}, {2, 2}, {2, 0}, {0, 2}}), ".corners", "cross");
  expect_refused_polygon(corners({{0, 0}, {2, 0}, {2, 2}, {0, 0}}), ".corners", "a corner twice");
  expect_refused_polygon("corners { x: nan y: 0 }" + corners({{0, 1}, {1, 1}}), ".corners[0].x",
                         "is not a number, expected a length");
}

TEST(OverlapErrors, AHoleThatIsNotInsideItsPolygon) {
  const std::string square = corners({{0, 0}, {9, 0}, {9, 9}, {0, 9}});
  const auto hole = [](double x, double y, double size) {
    return "holes { " + corners({{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}}) + " }";
  };
  expect_refused_polygon(square + hole(20, 0, 1), ".holes[0].corners", "outside the polygon");
  expect_refused_polygon(square + hole(1, 1, 1) + hole(8, 8, 3), ".holes[1].corners", "polygon's boundary");
  expect_refused_polygon(square + hole(1, 1, 3) + hole(3, 3, 3), ".holes[1].corners", "another hole");
  expect_refused_polygon(square + hole(1, 1, 3) + hole(2, 2, 1), ".holes[1].corners", "in one another");
  expect_refused_polygon(square + hole(-1, -1, 20), ".holes[0].corners", "outside the polygon");
  expect_refused_polygon(square + "holes { " + corners({{1, 1}, {2, 2}}) + " }", ".holes[0].corners",
                         "has 2 elements, expected at least 3");
}

// A bar of 10 m by 1 m as the outer model.
constexpr BoundingBox kBar{0, 10, 0, 1};

void accept(const std::string& overlap, const BoundingBox& outer, const BoundingBox& inner) {
  EXPECT_NO_THROW(require_inside(test::overlap_of(overlap), outer, inner)) << overlap;
}

void refuse(const std::string& overlap, const BoundingBox& outer, const BoundingBox& inner,
            const std::string& path, const std::string& text) {
  test::expect_refusal([&] { require_inside(test::overlap_of(overlap), outer, inner); },
                       "interface.overlap" + path, text);
}

// Requirement: both edges of a strip run through both models, which fill one cross-section there.
TEST(OverlapInside, AStripRunsThroughBothModels) {
  const std::string strip = test::strip(4, 0, 6, 0);
  accept(strip, kBar, kBar);
  accept(strip, {0, 6, 0, 1}, {4, 10, 0, 1});
  accept(strip, kBar, {4, 10, 0.05, 0.95});  // a packing whose rows do not fill the height
  accept(test::strip(4, 0, 6, 1), kBar, kBar);
  refuse(strip, {0, 5, 0, 1}, kBar, ".continuum_ends", "outside `continuum`");
  refuse(strip, kBar, {5, 10, 0, 1}, ".particles_begin", "outside `particles`");
  refuse(strip, {20, 30, 0, 1}, kBar, ".particles_begin", "outside `continuum`");
  refuse(strip, kBar, {4, 10, 0, 0.5}, "", "cross-section");
  refuse(strip, {0, 6, 0, 0.5}, {4, 10, 0, 1}, "", "cross-section");
  accept(test::strip(1, 0, 2, 3), kBar, kBar);
  refuse(test::strip(1, 0, 2, 3), kBar, {0.9, 8.1, 0, 1}, "", "cross-section");
}

// Requirement: around a patch inside a grid, particles fill the shape and the ring.
TEST(OverlapInside, ARingAroundAPatchInsideAGrid) {
  const BoundingBox grid{-10, 10, -10, 10};
  for (const std::string& shape : {test::box(-2, 2, -2, 2), test::circle(0, 0, 2)}) {
    const std::string ring = test::ring(shape, 1);
    accept(ring, grid, {-3, 3, -3, 3});
    accept(ring, grid, {-2.9, 2.9, -2.9, 2.9});  // a packing that lacks a row
    accept(ring, grid, {-5, 5, -5, 5});
    refuse(ring, grid, {-2.5, 3, -3, 3}, "", "not filled by `particles`");
    refuse(ring, grid, {-1, 1, -1, 1}, "", "not filled by `particles`");
    refuse(ring, {4, 10, -10, 10}, {-3, 3, -3, 3}, "", "lies outside `continuum`");
    refuse(ring, grid, {20, 30, -3, 3}, "", "not filled by `particles`");
    refuse(ring, {-1, 1, -1, 1}, {-3, 3, -3, 3}, "", "leaves nothing of `continuum`");
    refuse(ring, {-2.5, 10, -10, 10}, {-3, 3, -3, 3}, "", "not filled by `continuum`");
  }
}

// Requirement: where both models end together, a ring may stick out.
TEST(OverlapInside, ARingMayBeCutByFreeEdges) {
  const std::string ring = test::ring(test::box(4, 6, -1, 2), 1);
  accept(ring, kBar, {3, 7, 0, 1});
  accept(ring, kBar, {3, 7, 0.05, 0.95});
  accept(ring, kBar, {0, 10, 0, 1});
  refuse(ring, kBar, {3, 7, 0, 0.5}, "", "not filled by `particles`");
  refuse(ring, kBar, {3, 7, 0, 2.5}, "",
         "not filled by `continuum`");  // particles above the bar, in the ring
  accept(ring, kBar, {3, 7, 0, 1.1});
  accept(test::ring(test::box(4, 20, -3, 3), 1), kBar, {3, 10, 0, 1});             // the bar's end
  accept(test::ring(test::box(4, 6, -1, 20), 1), {0, 10, -10, 1}, {3, 7, -2, 1});  // at the surface
}

}  // namespace
}  // namespace adit::coupler

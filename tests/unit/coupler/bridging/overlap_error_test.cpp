// Impossible overlaps are refused in one sentence that names the field.
#include <gmock/gmock.h>

#include "coupler/bridging/overlap.hpp"
#include "protocol/scene/fields/check_rules.hpp"
#include "tests/support/overlaps.hpp"
#include "tests/support/refusals.hpp"

namespace adit::coupler::overlap_error_test {
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

}  // namespace
}  // namespace adit::coupler::overlap_error_test

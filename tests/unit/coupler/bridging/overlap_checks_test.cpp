// Overlaps must lie where both their models are, whatever the shape of these; a refusal names a place.
#include "coupler/bridging/overlap_checks.hpp"

#include <gmock/gmock.h>

#include <functional>

#include "tests/support/overlaps.hpp"
#include "tests/support/refusals.hpp"

namespace adit::coupler::overlap_checks_test {
namespace {

// What a model fills, with samples every so often in both directions.
struct Body {
  BoundingBox box;
  double step;
  std::function<bool(double, double)> is_there = [](double, double) { return true; };

  std::vector<double> samples() const {
    std::vector<double> points;
    for (int i = 0; box.x_min + i * step <= box.x_max + 1e-9; ++i)
      for (int j = 0; box.y_min + j * step <= box.y_max + 1e-9; ++j)
        if (const double x = box.x_min + i * step, y = box.y_min + j * step; is_there(x, y))
          points.insert(points.end(), {x, y});
    return points;
  }
};

// Zones of 0.5 m are sampled every 0.25 m, particles of 0.1 m radius about every 0.1 m.
Body zones(const BoundingBox& box) {
  return {box, 0.25};
}
Body particles(const BoundingBox& box) {
  return {box, 0.1};
}

void check(const std::string& overlap, const Body& outer, const Body& inner) {
  const auto outside = outer.samples(), inside = inner.samples();
  require_inside(test::overlap_of(overlap), {outer.box, outside}, {inner.box, inside});
}

void accept(const std::string& overlap, const Body& outer, const Body& inner) {
  EXPECT_NO_THROW(check(overlap, outer, inner)) << overlap;
}

void refuse(const std::string& overlap, const Body& outer, const Body& inner, const std::string& path,
            const std::string& text) {
  test::expect_refusal([&] { check(overlap, outer, inner); }, "interface.overlap" + path, text);
}

// A bar of 10 m by 1 m as the outer model.
const Body kBar = zones({0, 10, 0, 1});

// Requirement: both edges of a strip run through both models, which fill one cross-section there.
TEST(OverlapInside, AStripRunsThroughBothModels) {
  const std::string strip = test::strip(4, 0, 6, 0);
  accept(strip, kBar, particles({0, 10, 0, 1}));
  accept(strip, zones({0, 6, 0, 1}), particles({4, 10, 0, 1}));
  accept(strip, kBar, particles({4, 10, 0.05, 0.95}));  // a packing whose rows do not fill the height
  accept(test::strip(4, 0, 6, 1), kBar, particles({0, 10, 0, 1}));
  refuse(strip, zones({0, 5, 0, 1}), particles({0, 10, 0, 1}), ".continuum_ends", "outside `continuum`");
  refuse(strip, kBar, particles({5, 10, 0, 1}), ".particles_begin", "outside `particles`");
  refuse(strip, zones({20, 30, 0, 1}), particles({0, 10, 0, 1}), ".particles_begin", "outside `continuum`");
  refuse(strip, kBar, particles({4, 10, 0, 0.5}), "",
         "is not filled by `particles` at (4.25, 1) m, where `continuum` is: its nearest place is 0.502 m "
         "away; both "
         "must fill the overlap's cross-section");
  refuse(strip, {{0, 6, 0, 0.5}, 0.125}, particles({4, 10, 0, 1}), "", "is not filled by `continuum` at (");
  accept(test::strip(1, 0, 2, 3), kBar, particles({0, 10, 0, 1}));
  refuse(test::strip(1, 0, 2, 3), kBar, particles({0.9, 8.1, 0, 1}), "", "cross-section");
}

// Requirement: around a patch inside a grid, particles fill the ring.
TEST(OverlapInside, ARingAroundAPatchInsideAGrid) {
  const Body grid = zones({-10, 10, -10, 10});
  for (const std::string& shape : {test::box(-2, 2, -2, 2), test::circle(0, 0, 2)}) {
    const std::string ring = test::ring(shape, 1);
    accept(ring, grid, particles({-3, 3, -3, 3}));
    accept(ring, grid, particles({-2.9, 2.9, -2.9, 2.9}));  // a packing that lacks a row
    accept(ring, grid, particles({-5, 5, -5, 5}));
    refuse(ring, grid, particles({-2.5, 3, -3, 3}), "", "is not filled by `particles` at (-3, ");
    refuse(ring, grid, particles({-1, 1, -1, 1}), "", "not filled by `particles`");
    refuse(ring, zones({4, 10, -10, 10}), particles({-3, 3, -3, 3}), "", "lies outside `continuum`");
    refuse(ring, grid, particles({20, 30, -3, 3}), "", "not filled by `particles`");
    refuse(ring, zones({-1, 1, -1, 1}), particles({-3, 3, -3, 3}), "", "leaves nothing of `continuum`");
    refuse(ring, zones({-2, 10, -10, 10}), particles({-3, 3, -3, 3}), "",
           "not filled by `continuum` at (-3, ");
  }
}

// Requirement: where both models end together, a ring may stick out.
TEST(OverlapInside, ARingMayBeCutByFreeEdges) {
  const std::string ring = test::ring(test::box(4, 6, -1, 2), 1);
  accept(ring, kBar, particles({3, 7, 0, 1}));
  accept(ring, kBar, particles({3, 7, 0.05, 0.95}));
  accept(ring, kBar, particles({0, 10, 0, 1}));
  refuse(ring, kBar, particles({3, 7, 0, 0.5}), "", "not filled by `particles`");
  refuse(ring, kBar, particles({3, 7, 0, 2.5}), "",
         "not filled by `continuum`");  // particles above the bar, in the ring
  accept(ring, kBar, particles({3, 7, 0, 1.1}));
  accept(test::ring(test::box(4, 20, -3, 3), 1), kBar, particles({3, 10, 0, 1}));  // the bar's end
  accept(test::ring(test::box(4, 6, -1, 20), 1), zones({0, 10, -10, 1}),
         particles({3, 7, -2, 1}));  // the surface
}

// Requirement: a cavern that both models leave out is a free face of both, although the boxes around them
// hold it.
TEST(OverlapInside, TheCrownOfACavernIsAFreeFace) {
  Body rock = zones({-20, 20, -20, 20});
  rock.is_there = [](double x, double y) { return std::abs(x) >= 4 || std::abs(y) >= 4; };
  const std::string ring = test::ring(test::box(-3, 3, 4, 8), 1);
  accept(ring, rock, particles({-4.6, 4.6, 4, 9.5}));
  refuse(ring, zones(rock.box), particles({-4.6, 4.6, 4, 9.5}), "",
         "3) m, where `continuum` is: its nearest place is 1 m away");
  refuse(ring, rock, particles({-4.6, 4.6, 3, 9.5}), "", "is not filled by `continuum` at (");
}

// Requirement: the free face of a slope is followed within a row of particles, not by its box.
TEST(OverlapInside, ASlopingPortalIsAFreeFace) {
  const auto below = [](double intercept) {
    return [=](double x, double y) { return y <= intercept - 0.5 * x + 1e-9; };
  };
  Body slope = zones({0, 20, -10, 10}), face = particles({5, 15, -5, 10});
  slope.is_there = below(10);
  face.is_there = below(10);
  const std::string ring = test::ring(test::box(7, 13, -3, 9), 1.5);
  accept(ring, slope, face);
  face.is_there = below(9.9);
  accept(ring, slope, face);
  face.is_there = below(9);  // 0.9 m lower across the slope
  refuse(ring, slope, face, "", "is not filled by `particles` at (");
  face.is_there = below(11);
  refuse(ring, slope, face, "", "is not filled by `continuum` at (");
}

// Points, middles of edges and middles of zones between lines in both directions.
std::vector<double> graded(const std::vector<double>& lines) {
  const auto at = [&](std::size_t k) { return (lines[k / 2] + lines[(k + 1) / 2]) / 2; };
  std::vector<double> points;
  for (std::size_t i = 0; i < 2 * lines.size() - 1; ++i)
    for (std::size_t j = 0; j < 2 * lines.size() - 1; ++j) points.insert(points.end(), {at(i), at(j)});
  return points;
}

// Requirement: a grid fills an overlap whose width is less than its zones', however fast they grow.
TEST(OverlapInside, AGridThatIsCoarseForTheOverlap) {
  const std::vector<double> lines{-10,  -7,  -4.5, -3,  -2.6, -2.3, -2, -1.7,
                                  -1.3, 0.2, 2.5,  2.7, 2.9,  5,    8,  11};
  const Body patch = particles({-3.2, 3.2, -3.2, 3.2});
  const auto inside = patch.samples(), outside = graded(lines);
  for (const double width : {0.3, 0.8})
    EXPECT_NO_THROW(require_inside(test::overlap_of(test::ring(test::box(-2.4, 2.4, -2.4, 2.4), width)),
                                   {{-10, 11, -10, 11}, outside}, {patch.box, inside}))
        << width;
}

// Requirement: where a gap is refused between zones larger than the overlap's width, that is told too.
TEST(OverlapInside, AGapBetweenLargeZones) {
  refuse(test::ring(test::box(-2, 2, -2, 9), 0.5), {{-20, 20, -20, 0}, 2}, particles({-3, 3, -3, 10}), "",
         "its zones of about");
}

// Requirement: a hole of the inner model in the core is a hole; ground at which it merely ends is lost.
TEST(OverlapInside, InTheCoreOnlyHolesMayBeEmpty) {
  Body lining = particles({-4, 4, -4, 4});
  lining.is_there = [](double x, double y) { return std::hypot(x, y) >= 1.5; };
  accept(test::ring(test::circle(0, 0, 2.5), 1), zones({-10, 10, -10, 10}), lining);
  refuse(test::ring(test::box(4, 20, -3, 3), 1), kBar, particles({3, 7, 0, 1}), "",
         "m, where `continuum` is: its nearest place is 3 m away");
}

}  // namespace
}  // namespace adit::coupler::overlap_checks_test

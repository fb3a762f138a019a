// The energy weights of strips and rings.
#include "coupler/bridging/overlap.hpp"

#include "tests/unit/coupler/bridging/random_overlaps.hpp"

namespace adit::coupler::overlap_test {
namespace {

using test::overlap_of;

TEST(Overlap, WeightFallsLinearlyAcrossTheStrip) {
  const Overlap overlap = overlap_of(test::strip(4, 0, 6, 0));
  EXPECT_EQ(overlap.outer_weight(3, 7), 1);
  EXPECT_EQ(overlap.outer_weight(4, -7), 1);
  EXPECT_DOUBLE_EQ(overlap.outer_weight(4.5, 0.3), 0.75);
  EXPECT_EQ(overlap.outer_weight(6, 0), 0);
  EXPECT_EQ(overlap.outer_weight(8, 0), 0);
}

// Requirement: the inner model alone fills the shape, the outer one what lies beyond the width; the outer
// edge is rounded at the corners.
TEST(Overlap, WeightRisesWithTheDistanceFromTheShape) {
  const Overlap overlap = overlap_of(test::ring(test::box(-1, 1, -1, 1), 10));
  EXPECT_EQ(overlap.outer_weight(0.5, 0.5), 0);
  EXPECT_EQ(overlap.inner_weight(0.5, 0.5), 1);
  EXPECT_DOUBLE_EQ(overlap.outer_weight(0, 6), 0.5);
  EXPECT_DOUBLE_EQ(overlap.outer_weight(4, 5), 0.5);  // 3, 4 beyond the corner
  EXPECT_EQ(overlap.outer_weight(10, 10), 1);
  EXPECT_FALSE(overlap.contains(10, 10));
  EXPECT_EQ(overlap.inner_weight(0, 11.001), 0);
}

TEST(Overlap, RampsAreLinearCubicOrConstant) {
  const std::string strip = test::strip(4, 0, 0, 0);
  EXPECT_DOUBLE_EQ(overlap_of(strip, "LINEAR").outer_weight(1, 0), 0.25);
  EXPECT_DOUBLE_EQ(overlap_of(strip, "CUBIC").outer_weight(1, 0), 0.15625);
  EXPECT_DOUBLE_EQ(overlap_of(strip, "CONSTANT").outer_weight(1, 0), 0.5);
  for (const std::string ramp : {"LINEAR", "CUBIC", "CONSTANT"}) {
    const Overlap overlap = overlap_of(strip, ramp);
    EXPECT_EQ(overlap.outer_weight(0, 0), 0);
    EXPECT_EQ(overlap.outer_weight(4, 0), 1);
    EXPECT_DOUBLE_EQ(overlap.depth(1, 0), 0.25);
    EXPECT_EQ(overlap.depth(-1, 0), 0);
    EXPECT_EQ(overlap.depth(5, 0), 1);
  }
}

// Requirement: a particle on either edge is coupled, one beyond it is not; on the edge where the inner model
// ends it exists, with hardly any energy.
TEST(Overlap, OwnsItsEdges) {
  const Overlap overlap = overlap_of(test::strip(4, 0, 6, 0));
  for (const double x : {4.0, 5.0, 6.0}) EXPECT_TRUE(overlap.contains(x, 0));
  for (const double x : {3.999, 6.001}) EXPECT_FALSE(overlap.contains(x, 0));
  EXPECT_EQ(overlap.inner_weight(3.999, 0), 0);
  EXPECT_GT(overlap.inner_weight(4, 0), 0);
  EXPECT_LT(overlap.inner_weight(4, 0), 1e-8);
}

// Requirement: far from the origin, where coordinates have fewer digits, edges own what lies on them too.
RC_GTEST_PROP(Overlap, OwnsItsEdgesFarFromTheOrigin, ()) {
  const double shift = test::random_between(-1e6, 1e6), along = test::random_between(-1, 1),
               width = test::random_between(0.05, 1);
  const Overlap overlap = overlap_of(test::ring(test::circle(shift, -shift, 1), width),
                                     *rc::gen::element("LINEAR", "CUBIC", "CONSTANT"));
  const double sine = std::sqrt(1 - along * along);
  RC_ASSERT(overlap.contains(shift + along, -shift + sine));
  RC_ASSERT(overlap.outer_weight(shift + along, -shift + sine) == 0);
  const double x = shift + (1 + width) * along, y = -shift + (1 + width) * sine;
  RC_ASSERT(overlap.contains(x, y));
  RC_ASSERT(overlap.inner_weight(x, y) > 0 && overlap.inner_weight(x, y) < 1e-8);
}

// Requirement: whatever the overlap and the ramp, the two weights of a point lie in [0, 1] and share its
// energy fully; in the core the inner model is alone, beyond the overlap the outer one.
RC_GTEST_PROP(Overlap, SharesTheEnergyFully, ()) {
  const Overlap overlap =
      overlap_of(test::random_overlap(), *rc::gen::element("LINEAR", "CUBIC", "CONSTANT"));
  const double x = test::random_between(-3, 3), y = test::random_between(-3, 3);
  const double outer = overlap.outer_weight(x, y), inner = overlap.inner_weight(x, y);
  RC_ASSERT(outer >= 0 && outer <= 1 && inner >= 0 && inner <= 1);
  RC_ASSERT(std::abs(outer + inner - 1.0) <= 1.1e-9);
  if (!overlap.contains(x, y)) RC_ASSERT(outer == overlap.depth(x, y) && (outer == 0 || inner == 0));
}

TEST(Overlap, BoundsCutTheModelWhereTheStripFollowsAnAxis) {
  const BoundingBox box = overlap_of(test::strip(4, 0, 6, 0)).bounds({0, 10, -1, 1});
  EXPECT_NEAR(box.x_min, 4, 1e-7);
  EXPECT_NEAR(box.x_max, 6, 1e-7);
  EXPECT_EQ(box.y_min, -1);
  EXPECT_EQ(box.y_max, 1);
}

// Requirement: no point of the overlap is missed because the participant was not asked for it.
RC_GTEST_PROP(Overlap, BoundsHoldEveryPointOfTheOverlap, ()) {
  const Overlap overlap = overlap_of(test::random_overlap());
  const BoundingBox model{-2, 1.5, -1, 1}, box = overlap.bounds(model);
  const double x = test::random_between(-2, 1.5), y = test::random_between(-1, 1);
  if (overlap.contains(x, y)) RC_ASSERT(x >= box.x_min && x <= box.x_max && y >= box.y_min && y <= box.y_max);
}

}  // namespace
}  // namespace adit::coupler::overlap_test

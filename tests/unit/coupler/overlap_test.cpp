// The energy weights of a strip.
#include "coupler/bridging/overlap.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

Overlap strip(double x0, double y0, double x1, double y1) {
  scene::Overlap overlap;
  overlap.mutable_particles_begin()->set_x(x0);
  overlap.mutable_particles_begin()->set_y(y0);
  overlap.mutable_continuum_ends()->set_x(x1);
  overlap.mutable_continuum_ends()->set_y(y1);
  return Overlap(overlap);
}

TEST(Overlap, WeightFallsLinearlyAcrossTheStrip) {
  const Overlap overlap = strip(4, 0, 6, 0);
  EXPECT_EQ(overlap.continuum_weight(3, 7), 1);
  EXPECT_EQ(overlap.continuum_weight(4, -7), 1);
  EXPECT_DOUBLE_EQ(overlap.continuum_weight(4.5, 0.3), 0.75);
  EXPECT_EQ(overlap.continuum_weight(6, 0), 0);
  EXPECT_EQ(overlap.continuum_weight(8, 0), 0);
}

// Requirement: a particle on either edge is coupled, one beyond it is not; on the edge where particles begin
// it exists, with hardly any energy.
TEST(Overlap, OwnsItsEdges) {
  const Overlap overlap = strip(4, 0, 6, 0);
  for (const double x : {4.0, 5.0, 6.0}) EXPECT_TRUE(overlap.contains(x, 0));
  for (const double x : {3.999, 6.001}) EXPECT_FALSE(overlap.contains(x, 0));
  EXPECT_EQ(overlap.particle_weight(3.999, 0), 0);
  EXPECT_GT(overlap.particle_weight(4, 0), 0);
  EXPECT_LT(overlap.particle_weight(4, 0), 1e-8);
}

// Requirement: whatever the strip, the two weights of a point lie in [0, 1] and share its energy fully.
RC_GTEST_PROP(Overlap, SharesTheEnergyFully, ()) {
  const auto place = [] { return *rc::gen::inRange(-1000, 1000) / 37.0; };
  const double x0 = place(), y0 = place(), x = place(), y = place();
  const Overlap overlap = strip(x0, y0, x0 + 1 + std::abs(place()), place());
  const std::vector<double> point = {x, y};
  const double continuum = overlap.continuum_weights(point)[0],
               particles = overlap.particle_weights(point)[0];
  RC_ASSERT(continuum >= 0 && continuum <= 1 && particles >= 0 && particles <= 1);
  RC_ASSERT(std::abs(continuum + particles - 1.0) <= 1.1e-9);
}

TEST(Overlap, BoundsCutTheModelWhereTheStripFollowsAnAxis) {
  const BoundingBox box = strip(4, 0, 6, 0).bounds({0, 10, -1, 1});
  EXPECT_EQ(box.x_min, 4);
  EXPECT_EQ(box.x_max, 6);
  EXPECT_EQ(box.y_min, -1);
  EXPECT_EQ(box.y_max, 1);
}

TEST(Overlap, RefusesAStripWithoutWidth) {
  EXPECT_THROW(strip(4, 1, 4, 1), protocol::UserError);
}

}  // namespace
}  // namespace adit::coupler

// Requirements on the field between the particles.
#include "dem_server/coupling/triangulation.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/unit/dem_server/engines/lattice/lattice.hpp"

namespace adit::dem::triangulation_test {
namespace {

constexpr double kRadius = 0.3;
constexpr int kRows = 7, kDiscs = 9;

Assembly packing_at(double x, double y) {
  Model packing = test::rows_of(kRows, kDiscs, kRadius);
  for (double& value : packing.discs.x) value += x;
  for (double& value : packing.discs.y) value += y;
  return test::assemble(packing, 1.0);
}

double sum_of(const TrianglePlace& place, const std::vector<double>& values) {
  double sum = 0;
  for (std::size_t e = 0; e < 3; ++e) sum += place.shares[e] * values[place.particles[e]];
  return sum;
}

double between(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1 << 30) / (1 << 30);
}

// Every place of the packing's cells, also in the notches and halves at its boundary, has shares that sum to
// 1 and give linear fields, such as a rigid rotation, to rounding: near the origin and far from it.
RC_GTEST_PROP(Triangulation, ReproducesLinearFields, ()) {
  const double x0 = *rc::gen::element(0.0, 1e6, -3e5), y0 = *rc::gen::element(0.0, -1e6);
  const Assembly a = packing_at(x0, y0);
  const Triangulation triangulation(a.particles, ends_of(a.bonds));
  const double x = x0 + between(0, 2 * kRadius * kDiscs);
  const double y = y0 + between(0, std::sqrt(3.0) * kRadius * kRows);
  const auto place = triangulation.locate(x, y);
  RC_ASSERT(place);
  const auto& [i, j, k] = place->particles;
  RC_ASSERT(i != j && j != k && k != i);
  RC_ASSERT(std::abs(place->shares[0] + place->shares[1] + place->shares[2] - 1) <= 1e-15);
  const double spin = 3, tolerance = 1e-8 * kRadius + 4e-16 * std::hypot(x, y);
  std::vector<double> vx, vy;
  for (std::size_t p = 0; p < a.particles.size(); ++p) {
    vx.push_back(1 - spin * (a.particles.y[p] - y0));
    vy.push_back(2 + spin * (a.particles.x[p] - x0));
  }
  RC_ASSERT(std::abs(sum_of(*place, vx) - (1 - spin * (y - y0))) <= spin * tolerance);
  RC_ASSERT(std::abs(sum_of(*place, vy) - (2 + spin * (x - x0))) <= spin * tolerance);
}

// Between its outermost centres the packing is covered without gaps: no share is negative there.
RC_GTEST_PROP(Triangulation, InterpolatesInside, ()) {
  const Assembly a = packing_at(0, 0);
  const Triangulation triangulation(a.particles, ends_of(a.bonds));
  const auto place = triangulation.locate(between(2 * kRadius, 2 * kRadius * (kDiscs - 1)),
                                          between(std::sqrt(0.75), std::sqrt(3.0) * (kRows - 0.5)) * kRadius);
  RC_ASSERT(place);
  for (const double share : place->shares) RC_ASSERT(share >= 0 && share <= 1);
}

// A centre is its particle alone, also where rounding puts it beside; the middle of a bond is its two ends'.
TEST(Triangulation, CentresAndBondsTouchNoOtherParticle) {
  const Assembly a = packing_at(1e3, 0);
  const Particles& p = a.particles;
  const Triangulation triangulation(p, ends_of(a.bonds));
  const auto share_of = [](const TrianglePlace& place, std::uint32_t particle) {
    for (std::size_t e = 0; e < 3; ++e)
      if (place.particles[e] == particle) return place.shares[e];
    return 0.0;
  };
  for (std::uint32_t i = 0; i < p.size(); ++i)
    for (const double beside : {0.0, 1e-11}) {
      const auto place = triangulation.locate(p.x[i] + beside, p.y[i] - beside);
      ASSERT_TRUE(place);
      EXPECT_EQ(share_of(*place, i), 1) << i;
    }
  for (std::size_t k = 0; k < a.bonds.size(); ++k) {
    const std::uint32_t i = a.bonds.first[k], j = a.bonds.second[k];
    const auto place = triangulation.locate((p.x[i] + p.x[j]) / 2, (p.y[i] + p.y[j]) / 2);
    ASSERT_TRUE(place);
    EXPECT_NEAR(share_of(*place, i), 0.5, 1e-12);
    EXPECT_EQ(share_of(*place, i) + share_of(*place, j), 1);
  }
}

// The field ends a diameter away from the last triangle, and where the weights left a hole.
TEST(Triangulation, EndsADiameterAway) {
  const Assembly a = packing_at(0, 0);
  const Triangulation triangulation(a.particles, ends_of(a.bonds));
  const double bottom = std::sqrt(0.75) * kRadius;  // height of the lowest centres
  EXPECT_TRUE(triangulation.locate(3 * kRadius, bottom - 1.99 * kRadius));
  EXPECT_FALSE(triangulation.locate(3 * kRadius, bottom - 2.01 * kRadius));
  EXPECT_FALSE(triangulation.locate(-100, 0.5));
  EXPECT_FALSE(triangulation.locate(1e300, -1e300));

  const Model packing = test::rows_of(30, 30, kRadius);
  std::vector<double> centres(packing.discs.x.size()), midpoints(packing.bonds.size(), 1.0);
  const double middle = 30 * kRadius;
  for (std::size_t i = 0; i < centres.size(); ++i)
    centres[i] = std::hypot(packing.discs.x[i] - middle, packing.discs.y[i] - middle) > 10 * kRadius ? 1 : 0;
  const Assembly ring = test::assemble(packing, 1.0, {centres, midpoints, 1e-3});
  const Triangulation around(ring.particles, ends_of(ring.bonds));
  EXPECT_TRUE(around.locate(middle + 9 * kRadius, middle));
  EXPECT_FALSE(around.locate(middle, middle));
}

// One row of particles has no triangle, so no field.
TEST(Triangulation, ARowHasNoField) {
  const Assembly row = test::pair_of_particles();
  EXPECT_FALSE(Triangulation(row.particles, ends_of(row.bonds)).locate(0.5, 0.5));
}

}  // namespace
}  // namespace adit::dem::triangulation_test

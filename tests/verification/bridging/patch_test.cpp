// Requirement: a uniform strain passes through the overlap without spurious forces from the weights or the
// multipliers.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/overlaps.hpp"
#include "tests/verification/bridging/statics/coupled_statics.hpp"

namespace adit::patch_test {
namespace {

constexpr double kRadius = 0.5, kRow = std::numbers::sqrt3 * kRadius;
constexpr double kStrain = 1e-3;

// A bar under uniaxial stress. Zones are whole multiples of the lattice's spacings (5 x 2R wide, 2 rows
// high), so that with edges on their lines the sums over particles equal the integrals over zones. With
// ν = 1/3 slanting bonds carry nothing in uniaxial stress: for any other ν a lattice with n rows has only
// n − 1 layers of them, so that its free surfaces alone make it strain otherwise than a continuum of the same
// height, coupled or not.
test::CoupledPatch bar(fdm::ZoneKind zone) {
  constexpr double kLength = 40, kHeight = 6 * kRow, kPoisson = 1.0 / 3;
  return {
      .young = 1,
      .poisson = kPoisson,
      .block = {0, kLength, 0, kHeight, 8, 3},
      .zone = zone,
      .packed = {0, kLength, 0, kHeight},
      .radius = kRadius,
      .exact = [](double x,
                  double y) { return Eigen::Vector2d(kStrain * x, -kPoisson * kStrain * (y - kHeight / 2)); },
      .is_held_point = [](double x, double) { return x < 1e-9; },
      .is_held_particle = [](double x, double) { return x > kLength - 2.1 * kRadius; }};
}

// A square of grid around a patch of particles, its rim displaced as a uniform strain with all components.
test::CoupledPatch square(double zone_size) {
  constexpr double kHalf = 18;
  const auto zones = static_cast<std::uint32_t>(std::lround(2 * kHalf / zone_size));
  return {
      .young = 1,
      .poisson = 0.25,
      .block = {-kHalf, kHalf, -kHalf, kHalf, zones, zones},
      .packed = {-15, 15, -15, 15},
      .radius = kRadius,
      .exact =
          [](double x, double y) {
            return Eigen::Vector2d(kStrain * (x + 0.3 * y), kStrain * (0.3 * x - 0.5 * y));
          },
      .is_held_point = [](double x, double y) { return std::max(std::abs(x), std::abs(y)) > kHalf - 1e-9; },
      .is_held_particle = [](double, double) { return false; }};
}

// Error of the particles' strain, as a share of the strain.
double error(const test::CoupledPatch& patch, const std::string& overlap,
             const std::string& ramp = "LINEAR") {
  return test::strain_error(patch, test::equilibrium(patch, test::overlap_of(overlap, ramp))) / kStrain;
}

class PatchTest : public testing::TestWithParam<fdm::ZoneKind> {};

TEST_P(PatchTest, UniformStrainPassesThroughAStripBetweenGridLines) {
  const auto patch = bar(GetParam());
  const auto rest = test::equilibrium(patch, test::overlap_of(test::strip(15, 0, 25, 0)));
  EXPECT_LE(test::displacement_error(patch, rest), 1e-12 * kStrain * patch.block.x_max);
}

// Where an edge cuts zones and bonds, or bends, one weight stands for a zone of size h or a bond of length 2R
// over which the true one changes by up to h / Lo or 2R / Lo: forces no longer balance to the first order of
// these. The factor is that of the largest error of a cut zone's weight (Simpson's rule, 1/24 h / Lo).
double first_order(double zone_size, double width) {
  return (zone_size + 2 * kRadius) / width / 24;
}

TEST_P(PatchTest, AStripThatCutsZonesIsWrongToTheFirstOrderOfZoneOverWidth) {
  for (const double shift : {0.25, 0.75, 1.25, 2.5, 3.5, 4.75})
    EXPECT_LE(error(bar(GetParam()), test::strip(15 + shift, 0, 25 + shift, 0)), first_order(5, 10)) << shift;
}

INSTANTIATE_TEST_SUITE_P(BothZones, PatchTest,
                         testing::Values(fdm::ZoneKind::kAssumedStrain, fdm::ZoneKind::kMixedDiscretization),
                         [](const auto& info) {
                           return info.param == fdm::ZoneKind::kAssumedStrain ? "AssumedStrain"
                                                                              : "MixedDiscretization";
                         });

class RingPatch : public testing::TestWithParam<std::string> {};

TEST_P(RingPatch, IsWrongToTheFirstOrderOfZoneOverWidth) {
  for (const double zone : {2.0, 4.0})
    for (const double width : {4.0, 6.0, 8.0})
      EXPECT_LE(error(square(zone), test::ring(GetParam(), width)), first_order(zone, width))
          << zone << " " << width;
}

// Requirement: what the scene's documentation says of ramps. A cubic one costs no order. A constant one jumps
// at the edges: a wider overlap does not help.
TEST_P(RingPatch, ACubicRampIsOfTheSameOrderAConstantOneIsNot) {
  const double narrow = error(square(4), test::ring(GetParam(), 4), "CUBIC");
  const double wide = error(square(4), test::ring(GetParam(), 8), "CUBIC");
  EXPECT_LE(narrow, 1.5 * first_order(4, 4));  // its slope reaches 1.5 / Lo
  EXPECT_LE(wide, 1.5 * first_order(4, 8));
  for (const double width : {4.0, 8.0})
    EXPECT_GE(error(square(4), test::ring(GetParam(), width), "CONSTANT"), first_order(4, 4)) << width;
}

INSTANTIATE_TEST_SUITE_P(BoxAndCircle, RingPatch,
                         testing::Values(test::box(-4, 4, -4, 4), test::box(-3.6, 4.4, -4.2, 3.8),
                                         test::circle(0.1, 0.2, 4.3), test::circle(1.1, -0.7, 4.3)));

}  // namespace
}  // namespace adit::patch_test

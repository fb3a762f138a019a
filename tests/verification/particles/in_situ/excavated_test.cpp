// Requirement: a tunnel excavated in stressed ground of particles deforms it and redistributes its stress as
// Kirsch found in 1898, in one stage or in several; a lining that is installed later carries what comes
// later.
#include <gtest/gtest.h>

#include <complex>

#include "tests/verification/continuum/oracles/kirsch.hpp"
#include "tests/verification/particles/in_situ/in_situ.hpp"

namespace adit {
namespace {

using fdm::oracle::CartesianStress;
using fdm::oracle::Kirsch;

constexpr double kYoung = 1e9, kPoisson = 0.2, kShear = kYoung / (2 * (1 + kPoisson));
constexpr CartesianStress kFar{-5e6, -1e7, 0};
constexpr double kDisc = 0.125, kHole = 1.5;

// Particles around the tunnel in a continuum whose outline, 30 radii away, is held.
std::string lattice(const std::string& more) {
  return fmt::format(
      "material {{ young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 }} time {{ duration: 1e-3 }} "
      "initial_stress {{ xx: {} yy: {} }} statics {{ unbalanced_ratio: 1e-5 count_from_stage: 1 }} "
      "continuum {{ block {{ x_min: -45 x_max: 45 y_min: -45 y_max: 45 zones_x: 90 zones_y: 90 }} "
      "motions {{ where {{ x_max: -45 }} velocity {{ x: 0 y: 0 }} }} "
      "motions {{ where {{ x_min: 45 }} velocity {{ x: 0 y: 0 }} }} "
      "motions {{ where {{ y_max: -45 }} velocity {{ x: 0 y: 0 }} }} "
      "motions {{ where {{ y_min: 45 }} velocity {{ x: 0 y: 0 }} }} }} "
      "interface {{ overlap {{ around {{ box {{ x_min: -5 x_max: 5 y_min: -5 y_max: 5 }} }} width: 1.5 }} }} "
      "particles {{ packing {{ x_min: -7.1 x_max: 7.1 y_min: -7.1 y_max: 7.1 radius: {} }} {} }} ",
      kFar.xx, kFar.yy, kDisc, more);
}

std::string excavation(const std::string& where, int stage, double released = 1) {
  return fmt::format(
      "excavations {{ where {{ circle {{ centre {{ x: 0 y: 0 }} radius: {} }} {} }} stage: {} released: "
      "{} }} ",
      kHole, where, stage, released);
}

// The radius of the circle as large as the cells that were taken away.
double radius_of_hole(std::size_t taken) {
  return std::sqrt(static_cast<double>(taken) * 2 * std::numbers::sqrt3 * kDisc * kDisc / std::numbers::pi);
}

// Largest difference from what a hole in ground without end does, from its wall to three radii, over the
// largest displacement.
double displacement_error(const test::Drawn& drawn, double radius) {
  const Kirsch hole(radius, kFar, kShear, kPoisson), none(0, kFar, kShear, kPoisson);
  double worst = 0, largest = 0;
  for (std::size_t i = 0; i < drawn.x.size(); ++i) {
    const double x = drawn.x[i], y = drawn.y[i], r = std::hypot(x, y);
    if (r > 3 * radius) continue;
    const auto u = hole.displacement(x, y) - none.displacement(x, y);
    worst = std::max(worst, std::abs(u - std::complex(drawn.ux[i], drawn.uy[i])));
    largest = std::max(largest, std::abs(u));
  }
  return worst / largest;
}

// Mean of Kirsch's stress over a circle, weighed as that of particles (observe/circles.hpp).
CartesianStress mean_stress(const Kirsch& exact, double x, double y, double radius) {
  CartesianStress mean{0, 0, 0};
  double total = 0;
  constexpr int kRings = 20, kAngles = 40;
  for (int k = 0; k < kRings; ++k)
    for (int n = 0; n < kAngles; ++n) {
      const double r = (k + 0.5) / kRings, angle = 2 * std::numbers::pi * n / kAngles;
      const double weight = r * (1 - r * r) * (1 - r * r);
      const auto s = exact.stress(x + radius * r * std::cos(angle), y + radius * r * std::sin(angle));
      mean.xx += weight * s.xx;
      mean.yy += weight * s.yy;
      total += weight;
    }
  return {mean.xx / total, mean.yy / total, 0};
}

// Circles at the springline and at the crown, as near to the wall as they can lie.
constexpr double kCircle = 0.6, kAway = kHole + 0.7;
const std::string kHoop = test::stress_over(kAway, 0, kCircle) + test::stress_over(0, kAway, kCircle);

void expect_kirsch(test::Settled& settled, double displacement, double hoop) {
  const auto snapshot = settled.stepper.snapshots()[1];
  const test::Drawn drawn(snapshot);
  const auto all = static_cast<std::size_t>(snapshot.pieces(0).points_size()) / 2;
  const double radius = radius_of_hole(all - drawn.x.size());
  EXPECT_LT(displacement_error(drawn, radius), displacement);
  const Kirsch exact(radius, kFar, kShear, kPoisson);
  const auto stress = settled.histories[1];
  EXPECT_NEAR(stress[1] / mean_stress(exact, kAway, 0, kCircle).yy, 1, hoop);
  EXPECT_NEAR(stress[3] / mean_stress(exact, 0, kAway, kCircle).xx, 1, hoop);
}

TEST(ExcavatedParticles, DeformAsKirschFound) {
  test::Settled settled(lattice(excavation("", 1) + kHoop));
  expect_kirsch(settled, 0.03, 0.03);
}

TEST(ExcavatedParticles, EndAtTheSameStateInTwoStages) {
  test::Settled once(lattice(excavation("", 1))),
      twice(lattice(excavation("y_min: 0", 1) + excavation("", 3))),
      released(lattice(excavation("", 1, 0.5)));
  const test::Drawn a(once.stepper.snapshots()[1]), b(twice.stepper.snapshots()[1]),
      c(released.stepper.snapshots()[1]);
  ASSERT_EQ(a.x.size(), b.x.size());
  ASSERT_EQ(a.x.size(), c.x.size());
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    EXPECT_LT(std::hypot(a.ux[i] - b.ux[i], a.uy[i] - b.uy[i]), 0.01 * a.largest());
    EXPECT_LT(std::hypot(a.ux[i] - c.ux[i], a.uy[i] - c.uy[i]), 0.01 * a.largest());
    if (HasFailure()) return;
  }
}

// A plug of stiff particles that comes back after the ground has come to rest bears nothing.
TEST(ExcavatedParticles, LiningAfterReleaseCarriesNothing) {
  test::Settled settled(
      lattice(excavation("", 1) +
              "groups { name: 'lining' where { circle { centre { x: 0 y: 0 } radius: 1.5 } } stage: 2 "
              "bonds { normal_stiffness: 1e10 shear_stiffness: 3e9 } } " +
              test::stress_over(0.6, 0, 0.6)));
  for (const double stress : settled.histories[1]) EXPECT_LT(std::abs(stress), 1e-3 * 1e7);
}

}  // namespace
}  // namespace adit

#include "dem_server/engines/lattice/bond_forces.hpp"

#include <gtest/gtest.h>

#include "tests/unit/dem_server/engines/lattice/lattice.hpp"

namespace adit::dem::bond_law_test {
namespace {

using test::compute;

constexpr double kNormal = 7.0, kShear = 3.0;
const ContactBond kLaw{{kNormal, kShear}, kUnbreakable, kUnbreakable};

// Fn = kn times the change of length, on both particles, along the line between them.
TEST(BondLaw, NormalForceFollowsTheLength) {
  Assembly a = test::pair_of_particles();
  a.particles.ux[1] = 0.3;
  a.particles.uy[1] = 0.4;
  compute(kLaw, 0.1, a);
  const double length = std::hypot(1.3, 0.4), fn = kNormal * (length - 1);
  EXPECT_NEAR(a.bonds.normal_force[0], fn, 1e-14);
  EXPECT_NEAR(a.particles.fx[0], fn * 1.3 / length, 1e-14);
  EXPECT_NEAR(a.particles.fy[0], fn * 0.4 / length, 1e-14);
  EXPECT_NEAR(a.particles.fx[1], -fn * 1.3 / length, 1e-14);
  EXPECT_EQ(a.particles.moment[0], 0);
}

// A strain of 1e-12 far from the origin keeps its digits: forces come from displacements, not from places.
TEST(BondLaw, TinyStrainsKeepTheirDigits) {
  Assembly a = test::assemble(test::lattice_in({1e6, 1e6 + 2, 0, 0.9}, 0.5), 1.0);
  a.particles.ux[1] = 1e-12;
  compute(kLaw, 0.1, a);
  EXPECT_NEAR(a.bonds.normal_force[0] / (kNormal * 1e-12), 1, 1e-11);
}

// Fs grows by ks dt times the relative velocity across the bond; both particles feel the moment Fs L / 2.
TEST(BondLaw, ShearForceSumsTheSlip) {
  Assembly a = test::pair_of_particles();
  const double dt = 0.1;
  a.particles.vy[0] = 0.2;
  a.particles.vy[1] = 0.5;
  a.particles.vx[1] = 9;  // along the bond: no slip
  compute(kLaw, dt, a);
  compute(kLaw, dt, a);
  const double fs = 2 * kShear * dt * 0.3;
  EXPECT_NEAR(a.bonds.shear_force[0], fs, 1e-14);
  EXPECT_NEAR(a.particles.fy[0], fs, 1e-14);
  EXPECT_NEAR(a.particles.fy[1], -fs, 1e-14);
  EXPECT_NEAR(a.particles.moment[0], fs / 2, 1e-14);
  EXPECT_NEAR(a.particles.moment[1], fs / 2, 1e-14);
}

// Equal spins slip by w L, opposite ones roll without slip.
TEST(BondLaw, SpinsSlipOrRoll) {
  Assembly a = test::pair_of_particles();
  a.particles.spin = {2.0, 2.0};
  compute(kLaw, 0.1, a);
  EXPECT_NEAR(a.bonds.shear_force[0], -kShear * 0.1 * 2.0, 1e-14);
  a.particles.spin = {2.0, -2.0};
  const double before = a.bonds.shear_force[0];
  compute(kLaw, 0.1, a);
  EXPECT_EQ(a.bonds.shear_force[0], before);
}

// The weight multiplies what the particles feel, not the bond's own forces.
TEST(BondLaw, WeightMultipliesTheForcesOnTheParticles) {
  Assembly a = test::pair_of_particles();
  a.bonds.set_weight(0, 0.25);
  a.particles.ux[1] = 0.1;
  a.particles.vy[1] = 1;
  compute(kLaw, 0.1, a);
  const double length = 1.1, fn = kNormal * 0.1, fs = kShear * 0.1;
  EXPECT_NEAR(a.bonds.normal_force[0], fn, 1e-14);
  EXPECT_NEAR(a.particles.fx[0], 0.25 * fn, 1e-14);
  EXPECT_NEAR(a.particles.fy[0], 0.25 * fs, 1e-14);
  EXPECT_NEAR(a.particles.moment[0], 0.25 * fs * length / 2, 1e-14);
}

// A bond holds at its tensile strength and breaks at the next larger force.
TEST(BondLaw, BreaksInTensionJustAboveItsStrength) {
  Assembly a = test::pair_of_particles();
  a.particles.ux[1] = 0.1;
  compute(kLaw, 0.1, a);
  const double fn = a.bonds.normal_force[0];
  EXPECT_TRUE(compute({kLaw.stiffness, fn, kUnbreakable}, 0.1, a).second.empty());
  EXPECT_EQ(a.bonds.state[0], BondState::kIntact);
  const ContactBond weaker{kLaw.stiffness, std::nextafter(fn, 0), kUnbreakable};
  EXPECT_EQ(compute(weaker, 0.1, a).second, std::vector<std::uint32_t>{0});
  EXPECT_EQ(a.bonds.state[0], BondState::kTensileCrack);
  EXPECT_EQ(a.particles.fx[0], 0);
  EXPECT_TRUE(compute(weaker, 0.1, a).second.empty()) << "a bond breaks once";
}

// A bond holds at its shear strength, in either direction, and breaks at the next larger force.
TEST(BondLaw, BreaksInShearJustAboveItsStrength) {
  for (const double velocity : {1.0, -1.0}) {
    const double fs = kShear * 0.1;
    Assembly a = test::pair_of_particles();
    a.particles.vy[1] = velocity;
    EXPECT_TRUE(compute({kLaw.stiffness, kUnbreakable, fs}, 0.1, a).second.empty());
    Assembly b = test::pair_of_particles();
    b.particles.vy[1] = velocity;
    EXPECT_EQ(compute({kLaw.stiffness, kUnbreakable, std::nextafter(fs, 0)}, 0.1, b).second.size(), 1u);
    EXPECT_EQ(b.bonds.state[0], BondState::kShearCrack);
    EXPECT_EQ(b.bonds.shear_force[0], 0);
  }
}

// Where both strengths are exceeded the crack is tensile.
TEST(BondLaw, TensionIsJudgedBeforeShear) {
  Assembly a = test::pair_of_particles();
  a.particles.ux[1] = 0.1;
  a.particles.vy[1] = 1;
  compute({kLaw.stiffness, 1e-3, 1e-3}, 0.1, a);
  EXPECT_EQ(a.bonds.state[0], BondState::kTensileCrack);
}

// The strengths meet the unweighted force: a small weight does not protect a bond.
TEST(BondLaw, WeightDoesNotChangeTheStrength) {
  Assembly a = test::pair_of_particles();
  a.bonds.set_weight(0, 1e-3);
  a.particles.ux[1] = 0.1;
  EXPECT_EQ(compute({kLaw.stiffness, 0.9 * kNormal * 0.1, kUnbreakable}, 0.1, a).second.size(), 1u);
}

// A broken bond carries compression only, and no shear.
TEST(BondLaw, BrokenBondIsAFrictionlessContact) {
  Assembly a = test::pair_of_particles();
  a.particles.ux[1] = 0.1;
  compute({kLaw.stiffness, 1e-3, kUnbreakable}, 0.1, a);
  ASSERT_EQ(a.bonds.state[0], BondState::kTensileCrack);
  a.particles.vy[1] = 1;
  a.particles.ux[1] = 0.2;
  compute(kLaw, 0.1, a);
  EXPECT_EQ(a.particles.fx[0], 0);
  EXPECT_EQ(a.particles.fy[0], 0);
  a.particles.ux[1] = -0.2;
  const BondResult closed = compute(kLaw, 0.1, a).first;
  EXPECT_NEAR(a.particles.fx[0], -0.2 * kNormal, 1e-14);
  EXPECT_EQ(a.particles.fy[0], 0);
  EXPECT_EQ(a.particles.moment[0], 0);
  EXPECT_NEAR(closed.max_normal_force, 0.2 * kNormal, 1e-14);
}

// A shear break under compression gives up the shear energy only; the contact stays closed.
TEST(BondLaw, ShearBreakUnderCompressionReleasesShearOnly) {
  Assembly a = test::pair_of_particles();
  a.bonds.set_weight(0, 0.5);
  a.particles.ux[1] = -0.1;
  a.bonds.shear_force[0] = 2.0;
  const auto [result, broken] = compute({kLaw.stiffness, kUnbreakable, 1.0}, 0.1, a);
  ASSERT_EQ(broken.size(), 1u);
  EXPECT_NEAR(result.released, 0.5 * 2.0 * 2.0 / (2 * kShear), 1e-14);
  EXPECT_NEAR(a.particles.fx[0], -0.5 * kNormal * 0.1, 1e-14);
}

// A tensile break gives up normal and shear energy.
TEST(BondLaw, TensileBreakReleasesNormalAndShear) {
  Assembly a = test::pair_of_particles();
  a.particles.ux[1] = 0.1;
  a.bonds.shear_force[0] = 0.6;
  const BondResult result = compute({kLaw.stiffness, 0.5, kUnbreakable}, 0.1, a).first;
  EXPECT_NEAR(result.released, kNormal * 0.01 / 2 + 0.36 / (2 * kShear), 1e-14);
}

// The largest force is found with its bond, tension or compression, at any place of any run.
TEST(BondLaw, FindsTheStrongestBond) {
  Assembly a = test::assemble(test::rows_of(4, 11), 1.0);
  test::fill_randomly(a.particles.ux, 0.05, 3);
  test::fill_randomly(a.particles.uy, 0.05, 4);
  const BondResult result = compute(kLaw, 0.1, a).first;
  std::uint32_t best = 0;
  for (std::uint32_t k = 0; k < a.bonds.size(); ++k)
    if (std::abs(a.bonds.normal_force[k]) > std::abs(a.bonds.normal_force[best])) best = k;
  EXPECT_EQ(result.strongest_bond, best);
  EXPECT_EQ(result.max_normal_force, std::abs(a.bonds.normal_force[best]));
}

// A value that is not finite anywhere shows in the largest force.
TEST(BondLaw, LargestForceIsNotFiniteWhereAnyForceIsNot) {
  for (const double bad : {std::nan(""), -std::nan(""), std::numeric_limits<double>::infinity()}) {
    Assembly a = test::assemble(test::rows_of(4, 11), 1.0);
    a.particles.ux[17] = bad;
    EXPECT_FALSE(std::isfinite(compute(kLaw, 0.1, a).first.max_normal_force));
  }
}

// A long row gives the same bits whatever vectors and remainders it is computed in: bond k of a row is
// the same as that bond alone.
TEST(BondLaw, VectorsAndRemaindersGiveTheSameBits) {
  Assembly row = test::assemble(test::rows_of(1, 300), 1.0);
  for (auto* values :
       {&row.particles.ux, &row.particles.uy, &row.particles.vx, &row.particles.vy, &row.particles.spin})
    test::fill_randomly(*values, 0.1, 7);
  Assembly whole = row;
  compute(kLaw, 0.1, whole);
  for (std::size_t k = 0; k + 1 < row.particles.size(); ++k) {
    Assembly pair = test::pair_of_particles();
    for (auto member : {&Particles::ux, &Particles::uy, &Particles::vx, &Particles::vy, &Particles::spin})
      for (std::size_t end : {0u, 1u}) (pair.particles.*member)[end] = (row.particles.*member)[k + end];
    compute(kLaw, 0.1, pair);
    ASSERT_EQ(pair.bonds.normal_force[0], whole.bonds.normal_force[k]) << k;
    ASSERT_EQ(pair.bonds.shear_force[0], whole.bonds.shear_force[k]) << k;
  }
}

}  // namespace
}  // namespace adit::dem::bond_law_test

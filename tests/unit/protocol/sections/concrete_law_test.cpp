// Requirements on concrete under strains that come and go.
#include "protocol/sections/concrete_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fibre.hpp"
#include "protocol/sections/confined_concrete.hpp"
#include "protocol/sections/fibre_concrete.hpp"

namespace adit::sections::test::concrete_law_test {
namespace {

// C30/37.
const ConcreteLaw kLaw{1.05 * 32.8e9, 38e6, 2.16e-3, 2.9e6, 2.75e-3};

Fibre<ConcreteLaw, ConcreteState> concrete(const ConcreteLaw& law = kLaw) {
  return {law, virgin(law)};
}

// Requirement: under growing compression the stress is eq. 3.14 of EN 1992-1-1: its slope E at the origin,
// f_c at eps_c1, and the value that the equation has at 3.5 per mille.
TEST(ConcreteLaw, CompressionIsThatOfTheCode) {
  auto fibre = concrete();
  EXPECT_NEAR(fibre.to(-1e-7, 1), -1e-7 * kLaw.modulus, 1e-4 * 1e-7 * kLaw.modulus);
  EXPECT_NEAR(fibre.to(-2.16e-3), -38e6, 1);
  const double k = 1.05 * 32.8e9 * 2.16e-3 / 38e6, eta = 3.5 / 2.16;
  EXPECT_NEAR(fibre.to(-3.5e-3), -38e6 * (k * eta - eta * eta) / (1 + (k - 2) * eta), 1);
  EXPECT_EQ(fibre.to(-6e-3), 0);
}

// Requirement: after unloading, cracking and closing, the stress returns to the curve where it was left and
// goes on along it; between, the strain without stress is that of Karsan and Jirsa.
TEST(ConcreteLaw, ReturnsToItsEnvelope) {
  auto fibre = concrete(), never = concrete();
  const double peak = kLaw.peak_strain, left = fibre.to(-1.5 * peak);
  const double residual = peak * (0.145 * 1.5 * 1.5 + 0.13 * 1.5);
  EXPECT_NEAR(fibre.to(-residual), 0, 1e-6 * kLaw.strength);
  EXPECT_GT(fibre.to(-residual + 0.5e-4), 0);
  fibre.to(2e-3);
  EXPECT_NEAR(fibre.to(-residual), 0, 1e-6 * kLaw.strength);
  EXPECT_NEAR(fibre.to(-1.5 * peak), left, 1e-9 * kLaw.strength);
  EXPECT_NEAR(fibre.to(-1.7 * peak), never.to(-1.7 * peak), 1e-9 * kLaw.strength);
}

// Requirement: tension falls from f_t to nothing at the end strain; the residual strength of fibres stays.
TEST(ConcreteLaw, TensionSoftens) {
  auto fibre = concrete();
  const double cracking = kLaw.tensile_strength / kLaw.modulus;
  EXPECT_NEAR(fibre.to(cracking), 2.9e6, 1);
  EXPECT_NEAR(fibre.to((cracking + kLaw.tensile_end) / 2), 1.45e6, 1);
  EXPECT_EQ(fibre.to(3e-3), 0);
  ConcreteLaw with = kLaw;
  with.residual = rigid_plastic_model({4e6, 3.6e6}, 0.3);
  auto fibrous = concrete(with);
  EXPECT_NEAR(fibrous.to(3e-3), 1.2e6, 1);
  EXPECT_EQ(fibrous.to(9e-3), 0);  // beyond 2.5 mm in 0.3 m
}

// fib Model Code 2010, eqs. 5.6-4 to 5.6-6, by hand: f_R1 = 4, f_R3 = 3.6 MPa, w_u = 2.5 mm.
TEST(FibreConcrete, ModelsOfTheModelCode) {
  const ResidualTension linear = linear_model({4e6, 3.6e6}, 0.3);
  EXPECT_NEAR(linear.stress(0), 1.8e6, 1);
  EXPECT_NEAR(linear.stress(linear.end_strain), (0.5 * 3.6 - 0.2 * 4) * 1e6, 1);
  EXPECT_NEAR(linear.end_strain, 2.5e-3 / 0.3, 1e-12);
  // A thin section reaches 2 % first.
  EXPECT_NEAR(linear_model({4e6, 3.6e6}, 0.1).end_strain, 0.02, 1e-12);
}

// Requirement: whatever the path, the tangent never exceeds the modulus and what is dissipated never falls.
TEST(ConcreteLaw, NeitherStiffensNorCreatesEnergy) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> goal(-4e-3, 1.5e-3);
  for (int path = 0; path < 20; ++path) {
    ConcreteLaw law = kLaw;
    if (path % 2) law.residual = linear_model({4e6, 3.6e6}, 0.3);
    auto fibre = concrete(law);
    double lost = 0;
    for (int leg = 0; leg < 30; ++leg) {
      const double from = fibre.strain, to = goal(random);
      for (int i = 1; i <= 400; ++i) {
        const double before = fibre.state.stress, at = fibre.strain;
        fibre.to(from + (to - from) * i / 400, 1);
        EXPECT_LE((fibre.state.stress - before) / (fibre.strain - at), kLaw.modulus * (1 + 1e-6));
      }
      const double now = fibre.work - stored(fibre.state);
      EXPECT_GE(now, lost - 2e-3 * kLaw.strength * kLaw.peak_strain);  // steps of the trapezoidal rule
      lost = now;
    }
    EXPECT_GT(lost, 0);
  }
}

// Requirement: concrete inside stirrups follows Mander, Priestley and Park: a pressure of a tenth of the
// strength raises it to 1.57 times (their figure for equal pressures), at a strain of 3.8 times; the curve
// starts with the modulus of plain concrete, and nothing is left at twice the strain at which stirrups break.
TEST(ConfinedConcrete, IsThatOfMander) {
  const protocol::SteelValues stirrups{200e9, 400e6, 0, 0.09};
  const double ratio = 0.1 * kLaw.strength / (0.75 * stirrups.yield);
  const ConcreteLaw law = confined(kLaw, stirrups, {ratio, 0.75});
  EXPECT_NEAR(law.strength / kLaw.strength, 1.565, 0.001);
  EXPECT_NEAR(law.peak_strain / kLaw.peak_strain, 3.826, 0.004);
  EXPECT_NEAR(law.stirrups_break, 0.004 + 1.4 * 2 * ratio * 400e6 * 0.09 / law.strength, 1e-12);
  auto core = concrete(law);
  EXPECT_NEAR(core.to(-1e-8, 1) / -1e-8, law.modulus, 1e-4 * law.modulus);
  EXPECT_NEAR(core.to(-law.peak_strain), -law.strength, 1);
  EXPECT_GT(-core.to(-law.stirrups_break), 0.5 * law.strength);
  EXPECT_EQ(core.to(-2 * law.stirrups_break), 0);
}

}  // namespace
}  // namespace adit::sections::test::concrete_law_test

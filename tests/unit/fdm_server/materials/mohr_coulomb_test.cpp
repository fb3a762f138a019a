// Requirements on Mohr-Coulomb at a point: closed forms on simple paths, Koiter's conditions everywhere,
// dissipation.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "fdm_server/materials/mohr_coulomb.hpp"
#include "tests/unit/fdm_server/materials/stress_of.hpp"

namespace adit::fdm::test::mohr_coulomb_test {
namespace {

using std::numbers::pi;

constexpr double kDegree = pi / 180, kInf = std::numeric_limits<double>::infinity();
const Elasticity kElasticity{200e6, 100e6};

struct Path {
  SolidStress stress{};
  double plastic_shear_strain = 0, dissipated = 0;
  unsigned yields = 0;

  void add(const MohrCoulomb& law, const Strain& strain) {
    const SolidStress predicted = stress + stress_of(kElasticity, strain);
    const auto back = law.admissible(kElasticity, plastic_shear_strain, predicted);
    const Strain plastic = strain_of(kElasticity, predicted - back.stress);
    dissipated += product(stress + back.stress, plastic) / 2;
    plastic_shear_strain += back.yields ? shear_measure(plastic) : 0;
    stress = back.stress;
    yields = back.yields;
  }
  void add(const MohrCoulomb& law, const Strain& strain, int steps) {
    const double share = 1.0 / steps;
    for (int i = 0; i < steps; ++i)
      add(law, {share * strain.xx, share * strain.yy, share * strain.zz, share * strain.xy});
  }
};

// Strength in the largest and smallest principal stress: s1 (1 + sin) - s3 (1 - sin) = 2 c cos.
double on_cone(double sigma_1, const Strength& s) {
  return (sigma_1 * (1 + std::sin(s.friction_angle)) - 2 * s.cohesion * std::cos(s.friction_angle)) /
         (1 - std::sin(s.friction_angle));
}

// Triaxial compression, lateral stress held: the axial stress reaches the cone's s3 in the regime of an edge,
// and the flow has the dilation angle: volume strain over axial strain = (1 - N)/1 with N = (1 + sin psi)/(1
// - sin psi).
TEST(MohrCoulomb, TriaxialCompressionReachesTheConeAndDilates) {
  const Strength strength{30e3, 35 * kDegree, 10 * kDegree, 10e3};
  const MohrCoulomb law(strength);
  Path path;
  path.stress = {-100e3, -100e3, -100e3, 0};
  double volume = 0, axial = 0;
  for (int i = 0; i < 2000; ++i) {
    const double eyy = -1e-5;
    // strain to the sides so that their stress stays: by Newton's method on xx = zz, linear in each regime
    double side = 0;
    for (int k = 0; k < 30; ++k) {
      Path tried = path;
      tried.add(law, {side, eyy, side, 0});
      const double gap = tried.stress.xx + 100e3;
      Path other = path;
      other.add(law, {side + 1e-9, eyy, side + 1e-9, 0});
      const double slope = (other.stress.xx - tried.stress.xx) / 1e-9;
      if (std::abs(gap) < 1e-9 || slope == 0) break;
      side -= gap / slope;
    }
    path.add(law, {side, eyy, side, 0});
    if (i >= 1500) {
      volume += 2 * side + eyy;
      axial += eyy;
    }
  }
  EXPECT_NEAR(path.stress.yy, on_cone(-100e3, strength), 1e-10 * std::abs(path.stress.yy) + 1e-4);
  EXPECT_NEAR(path.stress.xx, -100e3, 1e-4);
  const double n = (1 + std::sin(strength.dilation_angle)) / (1 - std::sin(strength.dilation_angle));
  EXPECT_NEAR(volume / axial, 1 - n, 1e-6);
}

// Plane-strain compression with rigid sides (oedometer): elastic until yield; then s3 follows the cone
// through the elastic-plastic solution. In the closed form for psi = phi = 0 the difference of stresses stays
// 2 c and the mean grows by K.
TEST(MohrCoulomb, OedometerOfCohesiveGround) {
  const double cohesion = 50e3;
  const MohrCoulomb law({cohesion, 0, 0, kInf});
  Path path;
  path.add(law, {0, -0.01, 0, 0}, 7);
  const double mean = -kElasticity.bulk * 0.01;
  EXPECT_NEAR(path.stress.xx - path.stress.yy, 2 * cohesion, 1e-10 * cohesion);
  EXPECT_NEAR(path.stress.zz, path.stress.xx, 1e-10 * cohesion);
  EXPECT_NEAR((path.stress.xx + path.stress.yy + path.stress.zz) / 3, mean, 1e-10 * std::abs(mean));
}

// Simple shear of cohesive ground: tau = min(G gamma, c); all work beyond is dissipated, c times the plastic
// strain.
TEST(MohrCoulomb, SimpleShearDissipatesCohesionTimesPlasticStrain) {
  const double cohesion = 20e3, gamma = 1e-3;
  const MohrCoulomb law({cohesion, 0, 0, kInf});
  Path path;
  path.add(law, {0, 0, 0, gamma}, 100);
  const double plastic = gamma - cohesion / kElasticity.shear;
  EXPECT_NEAR(path.stress.xy, cohesion, 1e-10 * cohesion);
  EXPECT_NEAR(path.plastic_shear_strain, plastic, 1e-10 * plastic);
  EXPECT_NEAR(path.dissipated, cohesion * plastic, 1e-10 * cohesion * plastic);
}

// Direct shear under a normal stress that the volume is held for: associated flow climbs the cone,
// non-dilatant flow stays, with p sin phi + c cos phi as the radius of Mohr's circle.
TEST(MohrCoulomb, ShearAtConstantVolumeStaysAtTheRadiusOfTheMeanStress) {
  const Strength strength{10e3, 30 * kDegree, 0, 5e3};
  const MohrCoulomb law(strength);
  Path path;
  path.stress = {-200e3, -200e3, -200e3, 0};
  path.add(law, {0, 0, 0, 5e-3}, 50);
  const double radius = 200e3 * std::sin(30 * kDegree) + 10e3 * std::cos(30 * kDegree);
  EXPECT_NEAR(path.stress.xy, radius, 1e-10 * radius);
  EXPECT_NEAR(path.stress.xx + path.stress.yy, -400e3, 1e-10 * 400e3);
}

// Uniaxial and all-round extension stop at the tension cut-off, in one direction and in all three.
TEST(MohrCoulomb, TensionIsCutOff) {
  const Strength strength{100e3, 40 * kDegree, 0, 30e3};
  const MohrCoulomb law(strength);
  Path one, all;
  one.stress = {-200e3, 0, -200e3, 0};  // elastic sides stay below the cut-off
  one.add(law, {0, 2e-4 + 2e-4, 0, 0}, 10);
  EXPECT_NEAR(one.stress.yy, 30e3, 1e-10 * 30e3);
  EXPECT_EQ(one.yields, unsigned{kTensionNow});
  all.add(law, {0.01, 0.02, 0.03, 0.004}, 10);
  EXPECT_NEAR(all.stress.xx, 30e3, 1e-10 * 30e3);
  EXPECT_NEAR(all.stress.yy, 30e3, 1e-10 * 30e3);
  EXPECT_NEAR(all.stress.zz, 30e3, 1e-10 * 30e3);
  EXPECT_NEAR(all.stress.xy, 0, 1e-10 * 30e3);
}

// Without a cut-off of its own the cone ends at its apex.
TEST(MohrCoulomb, ConeEndsAtItsApex) {
  const double c = 12e3, phi = 25 * kDegree;
  const MohrCoulomb law({c, phi, 5 * kDegree, apex(c, phi)});
  Path path;
  path.add(law, {0.02, 0.01, 0.02, 0.01});
  for (const double s : {path.stress.xx, path.stress.yy, path.stress.zz})
    EXPECT_NEAR(s, c / std::tan(phi), 1e-9 * c);
}

// Cohesion that softens linearly with the plastic shear strain: simple shear in fine steps follows the closed
// form tau = c0 - h gamma_p with gamma_p = (gamma - c0/G)/(1 - h/G), but for the lag of one step, h
// gamma/steps/(1 - h/G)^2; then stays at the residual.
TEST(MohrCoulomb, CohesionSoftensWithPlasticShearStrain) {
  const double c0 = 40e3, c1 = 10e3, strain = 2e-3, h = (c0 - c1) / strain;
  const MohrCoulomb law({{0, {c0, 0, 0, kInf}}, {strain, {c1, 0, 0, kInf}}});
  const double gamma = 1.2e-3, plastic = (gamma - c0 / kElasticity.shear) / (1 - h / kElasticity.shear);
  double before = 0;
  for (const int steps : {1000, 2000, 4000}) {
    Path path;
    path.add(law, {0, 0, 0, gamma}, steps);
    const double error = std::abs(path.stress.xy - (c0 - h * plastic));
    EXPECT_LE(error, 1.01 * h * gamma / steps / std::pow(1 - h / kElasticity.shear, 2));
    if (before > 0) {
      EXPECT_NEAR(error, before / 2, 0.05 * before);
    }
    before = error;
  }
  Path path;
  path.add(law, {0, 0, 0, 0.01}, 1000);
  EXPECT_NEAR(path.stress.xy, c1, 1e-10 * c1);
}

// For random strengths and predictors anywhere: the stress that is returned is admissible to rounding, its
// principal directions are those of the predictor, an admissible predictor is left alone, and plastic work is
// not negative.
TEST(MohrCoulomb, EveryPredictorReturnsToTheYieldSurface) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  int corners = 0;
  for (int trial = 0; trial < 200000; ++trial) {
    const double phi = unit(random) < 0.2 ? 0 : 50 * kDegree * unit(random), c = 1e5 * unit(random) + 1e3;
    const double psi = phi * (trial % 3) / 2, cone_apex = apex(c, phi);
    const double tension =
        trial % 4 == 0 ? cone_apex : std::min(cone_apex, 3e5) * (trial % 4 == 1 ? 0 : unit(random));
    const MohrCoulomb law({c, phi, psi, tension});
    const auto wide = [&] { return 1e6 * (unit(random) - 0.6) * unit(random); };
    const SolidStress predicted{wide(), wide(), wide(), wide() / 2};
    const auto [stress, yields] = law.admissible(kElasticity, 0, predicted);
    const double p = (stress.xx + stress.yy) / 2, r = std::hypot((stress.xx - stress.yy) / 2, stress.xy);
    const double s1 = std::max(p + r, stress.zz), s3 = std::min(p - r, stress.zz);
    const double rounding =
        1e-9 * (std::abs(predicted.xx) + std::abs(predicted.yy) + std::abs(predicted.zz) + c);
    ASSERT_LE(s1 * (1 + std::sin(phi)) - s3 * (1 - std::sin(phi)) - 2 * c * std::cos(phi), rounding) << trial;
    ASSERT_LE(s1, tension + rounding) << trial;
    ASSERT_NEAR(stress.xy * (predicted.xx - predicted.yy), predicted.xy * (stress.xx - stress.yy),
                1e6 * rounding)
        << trial;
    const Strain plastic = strain_of(kElasticity, predicted - stress);
    ASSERT_GE(product(stress, plastic), -rounding * shear_measure(plastic) - 1e-9) << trial;
    corners += yields == (kShearNow | kTensionNow);
    if (yields == kElastic) {
      ASSERT_EQ(predicted.xx, stress.xx);
    }
  }
  EXPECT_GT(corners, 1000);
}

// The return is the one of Koiter's rule: for associated flow the closest point in the energy norm, so that
// no admissible stress lies closer to the predictor.
TEST(MohrCoulomb, AssociatedReturnIsTheClosestPoint) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  const double c = 50e3, phi = 30 * kDegree;
  const MohrCoulomb law({c, phi, phi, 20e3});
  for (int trial = 0; trial < 300; ++trial) {
    const SolidStress predicted{4e5 * unit(random), 4e5 * unit(random), 4e5 * unit(random),
                                2e5 * unit(random)};
    const auto stress = law.admissible(kElasticity, 0, predicted).stress;
    const double closest = elastic_energy(kElasticity, predicted - stress);
    for (int other = 0; other < 300; ++other) {
      const SolidStress any{stress.xx + 3e4 * unit(random), stress.yy + 3e4 * unit(random),
                            stress.zz + 3e4 * unit(random), stress.xy + 3e4 * unit(random)};
      const auto admissible = law.admissible(kElasticity, 0, any);
      if (admissible.yields != kElastic) continue;
      ASSERT_GE(elastic_energy(kElasticity, predicted - any), closest * (1 - 1e-12));
    }
  }
}

}  // namespace
}  // namespace adit::fdm::test::mohr_coulomb_test

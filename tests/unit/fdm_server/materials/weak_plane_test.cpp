// Requirements on the ubiquitous weak plane.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fdm_server/materials/weak_plane.hpp"
#include "tests/unit/fdm_server/materials/stress_of.hpp"

namespace adit::fdm::test::weak_plane_test {
namespace {

using std::numbers::pi;

constexpr double kDegree = pi / 180;
const Elasticity kElasticity{2e9, 1e9};

// Jaeger's strength of a specimen with planes at `dip`: s1 - s3 = 2 (c + p3 tan phi)/((1 - tan phi / tan
// beta) sin 2 beta), beta the angle of the planes from the direction of s3; brought there by compression in y
// at constant xx.
TEST(WeakPlane, StrengthOfCompressionIsJaegers) {
  const double c = 1e5, phi = 25 * kDegree, confining = 4e5;
  for (const double dip : {40.0, 50.0, 60.0, 70.0, 80.0}) {
    const double beta = dip * kDegree;
    const WeakPlane plane(beta, {c, phi, 0, c / std::tan(phi)});
    SolidStress stress{-confining, -confining, -confining, 0};
    const double expected =
        2 * (c + confining * std::tan(phi)) / ((1 - std::tan(phi) / std::tan(beta)) * std::sin(2 * beta));
    // xx and xy are held: the strain that needs follows by linear regression on two trial increments
    for (int step = 0; step < 4000; ++step) {
      const double eyy = -4e-6;
      double exx = 0, gamma = 0;
      for (int k = 0; k < 6; ++k) {
        const auto at = [&](double x, double g) {
          return plane.admissible(kElasticity, stress + stress_of(kElasticity, {x, eyy, 0, g})).stress;
        };
        const double h = 1e-9;
        const auto here = at(exx, gamma), dx = at(exx + h, gamma), dg = at(exx, gamma + h);
        const double a = (dx.xx - here.xx) / h, b = (dg.xx - here.xx) / h;
        const double d = (dx.xy - here.xy) / h, e = (dg.xy - here.xy) / h, determinant = a * e - b * d;
        if (std::abs(determinant) < 1e-9 * a * a) break;
        const double rx = -confining - here.xx, rs = -here.xy;
        exx += (e * rx - b * rs) / determinant;
        gamma += (a * rs - d * rx) / determinant;
      }
      stress = plane.admissible(kElasticity, stress + stress_of(kElasticity, {exx, eyy, 0, gamma})).stress;
    }
    EXPECT_NEAR(-stress.yy - confining, expected, 1e-3 * expected) << dip;
  }
}

// Slip at constant volume on a plane that does not dilate: shear stress c + p tan phi, normal stress
// unchanged.
TEST(WeakPlane, SlipsAtCoulombsStrengthWithoutDilation) {
  const double c = 1e5, phi = 30 * kDegree;
  for (const double dip : {0.0, 0.4, -1.1}) {
    const WeakPlane plane(dip, {c, phi, 0, 0});
    const SolidStress predicted = turned({-3e5, -5e5, -4e5, 9e5}, std::cos(dip), std::sin(dip));
    const auto [stress, yields] = plane.admissible(kElasticity, predicted);
    const auto local = turned(stress, std::cos(dip), -std::sin(dip));
    EXPECT_NEAR(local.xy, c + 5e5 * std::tan(phi), 1e-10 * c);
    EXPECT_NEAR(local.yy, -5e5, 1e-10 * c);
    EXPECT_NEAR(local.xx, -3e5, 1e-10 * c);
    EXPECT_EQ(yields, unsigned{kSlipNow});
  }
}

// Dilation pushes the plane shut: the normal stress falls by (lambda + 2 G) tan psi of the slip, by Koiter's
// rule.
TEST(WeakPlane, DilatingSlipStaysOnTheStrength) {
  const double c = 1e5, phi = 30 * kDegree, psi = 10 * kDegree;
  const WeakPlane plane(0, {c, phi, psi, 0});
  const SolidStress predicted{-3e5, -5e5, -4e5, -9e5};
  const auto stress = plane.admissible(kElasticity, predicted).stress;
  EXPECT_NEAR(-stress.xy, c - stress.yy * std::tan(phi), 1e-10 * c);
  const auto flow = strain_of(kElasticity, predicted - stress);
  EXPECT_NEAR(flow.yy, -flow.xy * std::tan(psi), 1e-12 * std::abs(flow.xy));
  EXPECT_NEAR(flow.xx, 0, 1e-12 * std::abs(flow.xy));
  EXPECT_NEAR(flow.zz, 0, 1e-12 * std::abs(flow.xy));
}

// Tension across the plane opens it: normal stress at the cut-off, shear what the cone leaves there.
TEST(WeakPlane, OpensAtItsTension) {
  const double c = 1e5, phi = 30 * kDegree;
  const WeakPlane plane(0, {c, phi, 0, 2e4});
  const auto opening = plane.admissible(kElasticity, {0, 3e5, 0, 1e4});
  EXPECT_NEAR(opening.stress.yy, 2e4, 1e-10 * c);
  EXPECT_NEAR(opening.stress.xy, 1e4, 1e-10 * c);
  EXPECT_EQ(opening.yields, unsigned{kOpeningNow});
  const auto both = plane.admissible(kElasticity, {0, 3e5, 0, 5e5});
  EXPECT_NEAR(both.stress.yy, 2e4, 1e-10 * c);
  EXPECT_NEAR(both.stress.xy, c - 2e4 * std::tan(phi), 1e-10 * c);
  EXPECT_EQ(both.yields, kSlipNow | kOpeningNow);
}

// The plane turns with the ground.
TEST(WeakPlane, TurnsWithTheGround) {
  const Strength strength{1e5, 0.5, 0.1, 1e4};
  const SolidStress predicted{-3e5, -5e5, -4e5, 9e5};
  const auto a = WeakPlane(0.9, strength).admissible(kElasticity, predicted).stress;
  const auto b = WeakPlane(0.4, strength)
                     .admissible(kElasticity, predicted,
                                 turned(WeakPlane(0.4, strength).direction(), std::cos(1.0), std::sin(1.0)))
                     .stress;
  EXPECT_NEAR(a.xx, b.xx, 1e-9);
  EXPECT_NEAR(a.xy, b.xy, 1e-9);
}

}  // namespace
}  // namespace adit::fdm::test::weak_plane_test

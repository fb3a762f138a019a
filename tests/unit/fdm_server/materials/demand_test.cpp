// Requirements on the demand at a point: closed forms on simple paths, and 1 exactly where the ground yields.
#include "fdm_server/materials/demand.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace adit::fdm::test::demand_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180, kInf = std::numeric_limits<double>::infinity();
const Elasticity kElasticity{200e6, 100e6};

YieldCone cone_of(const Strength& strength) {
  return MohrCoulomb(strength).cone(0);
}

// Uniaxial tension uses sigma / f_t and uniaxial compression sigma / f_c, f_c = 2 c cos phi / (1 - sin phi),
// at half of the strength by the radii of two circles: r / (c cos phi + r sin phi).
TEST(Demand, IsTheShareOfTheUniaxialStrength) {
  const double c = 5e6, phi = 35 * kDegree, tension = 2e6;
  const YieldCone cone = cone_of({c, phi, 0, tension});
  const double compressive = 2 * c * std::cos(phi) / (1 - std::sin(phi));
  for (const double share : {0.3, 1.0, 1.7})
    EXPECT_NEAR(demand(cone, point_stress({share * tension, 0, 0, 0})), share, 1e-12);
  EXPECT_NEAR(demand(cone, point_stress({0, -compressive, 0, 0})), 1, 1e-12);
  const double radius = compressive / 4;
  EXPECT_NEAR(demand(cone, point_stress({0, -compressive / 2, 0, 0})),
              radius / (c * std::cos(phi) + radius * std::sin(phi)), 1e-12);
  EXPECT_EQ(demand(cone, {}), 0);
}

// Under a confining pressure s3 the strength is f_c + s3 (1 + sin phi) / (1 - sin phi); equal pressures from
// all sides use nothing, and equal tension reaches the apex c / tan phi where there is no cut-off.
TEST(Demand, CountsTheConfiningPressure) {
  const double c = 5e6, phi = 35 * kDegree, confining = 3e6;
  const YieldCone cone = cone_of({c, phi, 0, kInf});
  const double slope = (1 + std::sin(phi)) / (1 - std::sin(phi)),
               axial = 2 * c * std::cos(phi) / (1 - std::sin(phi)) + slope * confining;
  EXPECT_NEAR(demand(cone, point_stress({-confining, -axial, -confining, 0})), 1, 1e-12);
  EXPECT_EQ(demand(cone, point_stress({-axial, -axial, -axial, 0})), 0);
  const double tension = c / std::tan(phi);
  EXPECT_NEAR(demand(cone, point_stress({tension, tension, tension, 0})), 1, 1e-12);
  EXPECT_NEAR(demand(cone, point_stress({tension / 2, tension / 2, tension / 2, 0})), 0.5, 1e-12);
}

// Without friction, c = s_u, the share is that of Tresca: the radius of the largest circle over s_u.
TEST(Demand, IsThatOfTrescaWithoutFriction) {
  const YieldCone cone = cone_of({40e3, 0, 0, kInf});
  EXPECT_NEAR(demand(cone, point_stress({0, 0, 0, 30e3})), 0.75, 1e-12);
  EXPECT_NEAR(demand(cone, point_stress({-1e6, -1e6, -1e6, 30e3})), 0.75, 1e-12);
}

// Of any stress: above 1 exactly where the law takes the stress back, 1 at the stress that it leaves.
TEST(Demand, IsOneWhereTheGroundYields) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> stress(-8e6, 3e6), shear(-3e6, 3e6);
  for (const Strength& strength :
       {Strength{1e6, 30 * kDegree, 10 * kDegree, 0.5e6}, Strength{1e6, 30 * kDegree, 0, kInf},
        Strength{2e6, 0, 0, 1e6}, Strength{2e6, 0, 0, kInf}, Strength{0, 35 * kDegree, 0, 0}}) {
    const MohrCoulomb law(strength);
    const double dip = 0.4;
    const WeakPlane plane(dip, strength);
    int yielded = 0;
    const auto on_cone = [&](const SolidStress& s) { return demand(law.cone(0), point_stress(s)); };
    const auto on_plane = [&](const SolidStress& s) {
      return demand(plane.strength(), plane.direction(), point_stress(s));
    };
    for (int i = 0; i < 2000; ++i) {
      const SolidStress predicted{stress(random), stress(random), stress(random), shear(random)};
      const auto [left, yields] = law.admissible(kElasticity, 0, predicted);
      const auto [left_on_plane, slips] = plane.admissible(kElasticity, predicted);
      EXPECT_EQ(on_cone(predicted) >= 1, yields != kElastic);
      EXPECT_EQ(on_plane(predicted) >= 1, slips != kElastic);
      yielded += yields != kElastic;
      if (strength.cohesion == 0) continue;  // where the rounding of a stress of 0 is all that is left
      if (yields != kElastic) {
        EXPECT_NEAR(on_cone(left), 1, 1e-9);
      }
      if (slips != kElastic) {
        EXPECT_NEAR(on_plane(left_on_plane), 1, 1e-9);
      }
    }
    EXPECT_GT(yielded, 200);
  }
}

// Turned or mirrored with its axes, a stress uses the same share, and of a weak plane with the plane.
TEST(Demand, IsTheSameTurnedAndMirrored) {
  const Strength strength{1e6, 30 * kDegree, 0, 0.5e6};
  const YieldCone cone = cone_of(strength);
  const SolidStress stress{-2e6, 0.3e6, -0.4e6, 0.6e6}, mirrored{stress.xx, stress.yy, stress.zz, -stress.xy};
  const double here = demand(cone, point_stress(stress));
  EXPECT_NEAR(demand(cone, point_stress(mirrored)), here, 1e-12);
  const WeakPlane plane(0.3, strength), image(-0.3, strength);
  const double on_plane = demand(plane.strength(), plane.direction(), point_stress(stress));
  EXPECT_GT(on_plane, 0.1);
  EXPECT_NEAR(demand(image.strength(), image.direction(), point_stress(mirrored)), on_plane, 1e-12);
  for (const double angle : {0.5, 1.4}) {
    const double cosine = std::cos(angle), sine = std::sin(angle);
    EXPECT_NEAR(demand(cone, point_stress(turned(stress, -cosine, sine))), here, 1e-12);
  }
}

}  // namespace
}  // namespace adit::fdm::test::demand_test

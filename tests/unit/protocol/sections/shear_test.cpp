// Requirements on the shear capacity: the equations of EN 1992-1-1, 6.2, worked by hand.
#include "protocol/sections/shear_capacity.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace adit::sections::test::shear_test {
namespace {

// b = 300, h = 500, d = 450 mm, 1147 mm^2, C30/37: k = 1.6667, rho_l = 0.008496, (100 rho_l f_ck)^(1/3)
// = 2.943, V_Rd,c = 0.12 x 1.6667 x 2.943 x 300 x 450 = 79.5 kN; under 300 kN of compression 0.15 x 2 MPa x b
// d = 40.5 kN more, under 300 kN of tension as much less.
TEST(Shear, WithoutStirrups) {
  const SectionShape shape{0.5, 0.3, {{0.2, 1147e-6, 0.02}}};
  const ShearMaterials materials{30e6, 1.5, 20e6, 435e6, 0};
  const auto capacity = [&](double thrust) {
    return shear_capacity(shape, materials, Bending::kOuterStretched, thrust);
  };
  EXPECT_NEAR(capacity(0), 79.5e3, 0.1e3);
  EXPECT_NEAR(capacity(-300e3), 120.0e3, 0.1e3);
  EXPECT_NEAR(capacity(300e3), 39.0e3, 0.1e3);
  // Without bars on the stretched side v_min = 0.035 k^1.5 f^0.5 is left: d = 0.9 h here too.
  EXPECT_NEAR(shear_capacity(shape, materials, Bending::kInnerStretched, 0),
              0.035 * std::pow(5.0 / 3, 1.5) * std::sqrt(30.0) * 1e6 * 0.3 * 0.45, 1);
}

// Light stirrups yield at cot theta = 2.5, eq. 6.8; heavy ones crush the struts at 45 degrees, eq. 6.9;
// between, both reach their limits at once.
TEST(Shear, WithStirrups) {
  const SectionShape shape{0.5, 0.3, {{0.2, 1147e-6, 0.02}}};
  const double z = 0.9 * 0.45, struts = 0.3 * z * 0.6 * (1 - 30.0 / 250) * 20e6;
  const auto capacity = [&](double area) {
    return shear_capacity(shape, {30e6, 1.5, 20e6, 435e6, area}, Bending::kOuterStretched, 0);
  };
  EXPECT_NEAR(capacity(335e-6), 335e-6 * z * 435e6 * 2.5, 1);
  EXPECT_NEAR(capacity(20e-3), struts / 2, 1);
  const double between = 2e-3, steel = between * z * 435e6, angle = std::asin(std::sqrt(steel / struts));
  EXPECT_NEAR(capacity(between), steel / std::tan(angle), 1);
  EXPECT_NEAR(capacity(between), struts * std::sin(angle) * std::cos(angle), 1);
}

}  // namespace
}  // namespace adit::sections::test::shear_test

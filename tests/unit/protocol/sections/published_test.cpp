// Requirements: published figures of sections are met.
#include <gtest/gtest.h>

#include "protocol/sections/capacity.hpp"
#include "protocol/sections/section_materials.hpp"
#include "protocol/sections/shear_capacity.hpp"

namespace adit::sections::test::published_test {
namespace {

// SP 16:1980, Design Aids for Reinforced Concrete to IS 456, table H: the force C_1 f_ck b D of wholly
// compressed concrete and its distance C_2 D from the most compressed face, by x_u/D. IS 456 has the same
// diagram and the same pivots as EN 1992-1-1, with the strength 0.446 f_ck and 3/7 D.
TEST(Published, StressBlocksOfSp16) {
  struct Row {
    double x, force, depth;  // x_u/D, C_1, C_2
  };
  const double strength = 15e6, d = 0.5;
  const Capacity capacity({d, 1, {}}, {{0.446 * strength, 0.002, 0.0035, 2}, 200e9, 1, 0.01});
  for (const auto& [x, force, depth] :
       {Row{1.0, 0.361, 0.416}, Row{1.1, 0.384, 0.443}, Row{1.2, 0.399, 0.458}, Row{1.3, 0.409, 0.468},
        Row{1.4, 0.417, 0.475}, Row{1.5, 0.422, 0.480}}) {
    const double curvature = 0.002 / (x - 3.0 / 7) / d;
    const auto [thrust, moment] = capacity.forces(curvature * (d / 2 - x * d), curvature);
    EXPECT_NEAR(capacity.moment(Bending::kOuterStretched, thrust), moment, 1e-6 * strength * d * d) << x;
    EXPECT_NEAR(-thrust / (strength * d), force, 0.0006) << x;
    EXPECT_NEAR(0.5 - moment / -thrust / d, depth, 0.0006) << x;
  }
}

// M. G. Shah and C. M. Kale, RCC Theory and Design, 2nd edition, Macmillan: worked example 15.1. A beam of
// M15 and Fe 250, 300 mm wide, bars of 3940 mm^2 at 800 mm and of 795 mm^2 at 40 mm: 556.3 kN m.
TEST(Published, DoublyReinforcedBeamOfShahAndKale) {
  const double h = 0.85;
  const Capacity capacity({h, 0.3, {{0.04 - h / 2, 795e-6, 0.0225}, {0.8 - h / 2, 3940e-6, 0.032}}},
                          {{0.446 * 15e6, 0.002, 0.0035, 2}, 200e9, 0.87 * 250e6, 0.1});
  EXPECT_NEAR(capacity.moment(Bending::kOuterStretched, 0), 556.3e3, 0.01 * 556.3e3);
}

// The same book, example 18.3 (ii): a column of M15 and Fe 250, 225 by 500 mm, 2463 mm^2 at 45 mm from either
// face, with the neutral axis at 330 mm: 384.5 kN and 261.5 kN m.
TEST(Published, ColumnOfShahAndKale) {
  const double h = 0.5;
  const Capacity capacity({h, 0.225, {{0.045 - h / 2, 2463e-6, 0.028}, {h / 2 - 0.045, 2463e-6, 0.028}}},
                          {{0.446 * 15e6, 0.002, 0.0035, 2}, 200e9, 0.87 * 250e6, 0.1});
  EXPECT_NEAR(capacity.moment(Bending::kOuterStretched, -384.5e3), 261.5e3, 0.01 * 261.5e3);
  const double curvature = 0.0035 / 0.33;
  EXPECT_NEAR(capacity.forces(-0.0035 + curvature * h / 2, curvature).thrust, -384.5e3, 0.01 * 384.5e3);
}

// Eurocodeapplied.com, ULS of rectangular sections, as quoted by the verification of XC
// (test_ec2_interaction_diagram_02): 1.0 by 0.6 m, C25/30, B500B, 6 bars of 16 mm at 74 mm from one face, of
// 4 mm at 68 mm from the other, pure bending: 268.71 kN m.
TEST(Published, WallOfEurocodeapplied) {
  const double h = 0.6, quarter = 0.7853981633974483;
  const SectionShape shape{h,
                           1,
                           {{0.068 - h / 2, 6 * quarter * 4e-3 * 4e-3, 4e-3},
                            {h / 2 - 0.074, 6 * quarter * 16e-3 * 16e-3, 16e-3}}};
  const Capacity capacity(
      shape, capacity_materials(concrete_values(*protocol::concrete_of("C25/30"), Values::kDesign),
                                steel_values(*protocol::steel_of("B500B"), Values::kDesign)));
  EXPECT_NEAR(capacity.moment(Bending::kOuterStretched, 0), 268.71e3, 0.01 * 268.71e3);
}

// European Concrete Platform, Eurocode 2 Worked Examples (2008), example 6.3, as quoted by the verification
// of XC (test_EC2_shear_01): a cracked section of C40/50, 100 mm wide, 200 mm thick, d = 175 mm, without bars
// that count, under a compression of 5 MPa: V_Rd,c = 24.08 kN, from v_min.
TEST(Published, SlabWithoutStirrups) {
  const SectionShape shape{0.2, 0.1, {{0.075, 1e-12, 0.01}}};
  const ConcreteValues concrete = concrete_values(*protocol::concrete_of("C40/50"), Values::kDesign);
  const SteelValues steel = steel_values(*protocol::steel_of("B500B"), Values::kDesign);
  EXPECT_NEAR(
      shear_capacity(shape, shear_materials(concrete, steel, 0), Bending::kOuterStretched, -5e6 * 0.2 * 0.1),
      24.08e3, 0.002 * 24.08e3);
}

}  // namespace
}  // namespace adit::sections::test::published_test

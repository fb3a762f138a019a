// Requirement: particles of any kind start under the stated stress and stand still.
#include <gtest/gtest.h>

#include "tests/verification/particles/in_situ/in_situ.hpp"

namespace adit::at_rest_test {
namespace {

constexpr double kStiffness = 1e9, kSize = 10, kDensity = 2500, kGravity = 9.80665;

// Random discs with a stiff and a soft group, a hole-to-be, a smooth and an open joint that the stress
// closes.
std::string random_ground(const std::string& more) {
  return "particles { random_packing { x_min: -5 x_max: 5 y_min: -5 y_max: 5 radius_min: 0.09 radius_max: "
         "0.13 "
         "stress: 1e5 } bonds { normal_stiffness: 1e9 shear_stiffness: 4e8 reach: 0.05 } contacts { "
         "friction: 1 } "
         "groups { name: 'stiff' where { x_min: 2 } bonds { normal_stiffness: 1e10 shear_stiffness: 4e9 } } "
         "groups { name: 'soft' where { x_max: -2 } bonds { normal_stiffness: 3e8 shear_stiffness: 1e8 } } "
         "joints { from { x: -4 y: -3.5 } to { x: 3.5 y: -2.5 } smooth { normal_stiffness: 1e10 "
         "shear_stiffness: "
         "1e9 friction: 1 } } "
         "joints { from { x: -3.5 y: 2.6 } to { x: 3.5 y: 3 } open: true } " +
         more + "} ";
}

std::string at_rest(const std::string& stress, const std::string& model) {
  return "material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2500 } time { duration: 1e-3 } "
         "statics { unbalanced_ratio: 1e-6 count_from_stage: 0 } initial_stress { " +
         stress + " } " + model;
}

const std::string kUniform = "xx: -5e5 yy: -1e6 xy: 5e4";

TEST(InSitu, RandomDiscsStandStill) {
  test::Settled settled(at_rest(kUniform, random_ground(test::held_outside(-4.4, 4.4, -4.4, 4.4) +
                                                        test::stress_over_box(-3, 3, -3, 3, 1.4))));
  EXPECT_LE(test::Drawn(settled.stepper.snapshots().front()).largest(), 1e-4 * 1e6 / kStiffness * kSize);
  const test::MeanStress mean(settled.histories[0]);
  EXPECT_NEAR(mean.xx, -5e5, 0.01 * 1e6);
  EXPECT_NEAR(mean.yy, -1e6, 0.01 * 1e6);
  EXPECT_NEAR(mean.xy, 5e4, 0.01 * 1e6);
  EXPECT_TRUE(settled.cracks().empty());
}

// Layers of the packing's own density below a free surface, and their weight.
TEST(InSitu, RandomDiscsStandStillUnderTheirWeight) {
  const std::string layers =
      "surface: 5 layers { bottom: 0 density: 2500 k0: 0.5 } "
      "layers { bottom: -5 density: 2500 k0: 0.8 }";
  test::Settled settled(
      at_rest(layers, random_ground(fmt::format(
                          "body_loads {{ acceleration {{ y: {} }} }} "
                          "motions {{ where {{ x_max: -4.4 }} velocity {{ x: 0 y: 0 }} }} "
                          "motions {{ where {{ x_min: 4.4 }} velocity {{ x: 0 y: 0 }} }} "
                          "motions {{ where {{ y_max: -4.4 x_min: -4.3999 x_max: 4.3999 }} velocity {{ x: 0 "
                          "y: 0 }} }} {}",
                          -kGravity, test::stress_over_box(-3, 3, -3, 3, 1.4)))));
  const double deepest = kDensity * kGravity * kSize;
  EXPECT_LE(test::Drawn(settled.stepper.snapshots().front()).largest(), 1e-4 * deepest / kStiffness * kSize);
  EXPECT_NEAR(test::MeanStress(settled.histories[0]).yy, -deepest / 2, 0.01 * deepest / 2);
}

// The same discs inside a continuum, which bears its share of the stress in the overlap: both balance as far
// as the discs resolve the stress that both share. What is left moves them by less than 2 % of the stress's
// own strain, and by a quarter of that where no groups differ in stiffness; discs of half the size move half
// as far.
std::string in_a_continuum(const std::string& of_particles, const std::string& of_continuum) {
  return random_ground(test::stress_over_box(-2.8, 2.8, -2.8, 2.8, 1.2) + of_particles) +
         "continuum { block { x_min: -12 x_max: 12 y_min: -12 y_max: 12 zones_x: 48 zones_y: 48 } "
         "motions { where { x_max: -12 } velocity { x: 0 } } motions { where { x_min: 12 } velocity { x: 0 } "
         "} motions { where { y_max: -12 } velocity { y: 0 } } " +
         of_continuum +
         "} interface { overlap { around { box { x_min: -4 x_max: 4 y_min: -4 y_max: 4 } } width: 0.8 } } ";
}

TEST(InSitu, RandomDiscsInAContinuumStandStill) {
  test::Settled settled(
      at_rest("xx: -5e5 yy: -1e6", in_a_continuum("", "motions { where { y_min: 12 } velocity { y: 0 } } ")));
  const test::MeanStress mean(settled.histories[1]);
  EXPECT_NEAR(mean.xx, -5e5, 0.01 * 1e6);
  EXPECT_NEAR(mean.yy, -1e6, 0.01 * 1e6);
  EXPECT_NEAR(mean.xy, 0, 0.01 * 1e6);
  EXPECT_LE(test::Drawn(settled.stepper.snapshots()[1]).largest(), 0.02 * 1e6 / kStiffness * kSize);
}

TEST(InSitu, RandomDiscsInAContinuumStandStillUnderTheirWeight) {
  const std::string weight = fmt::format("body_loads {{ acceleration {{ y: {} }} }} ", -kGravity);
  test::Settled settled(
      at_rest("surface: 12 layers { bottom: -12 density: 2500 k0: 0.5 }", in_a_continuum(weight, weight)));
  const double middle = kDensity * kGravity * 12, deepest = kDensity * kGravity * 17;
  const test::MeanStress mean(settled.histories[1]);
  const test::Drawn drawn(settled.stepper.snapshots()[1]);
  EXPECT_NEAR(mean.xx, -middle / 2, 0.01 * middle);
  EXPECT_NEAR(mean.yy, -middle, 0.01 * middle);
  EXPECT_LE(drawn.largest(), 0.02 * deepest / kStiffness * kSize);
}

}  // namespace
}  // namespace adit::at_rest_test

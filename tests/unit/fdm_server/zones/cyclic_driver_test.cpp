// Requirements on the cyclic simple shear test of one zone: it finds the constant with which the ground
// liquefies after the cycles asked for, whatever the law of the skeleton, or says why there is none.
#include "fdm_server/zones/laws/cyclic_driver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace adit::fdm::test::cyclic_driver_test {
namespace {

// Sands of Boulanger & Ziotopoulou (2017, UCD/CGM-17/01): blow count (N1)60 and cyclic resistance.
struct Sand {
  double blows, resistance;
};
constexpr Sand kSands[] = {{5.6, 0.09}, {13.9, 0.147}, {25.9, 0.312}};
constexpr double kFriction = 33 * std::numbers::pi / 180;

// With the speed of shear waves at 100 kPa of the same report.
Material material(const Sand& sand, double friction = kFriction) {
  const double speed = 85 * std::pow(sand.blows + 2.5, 0.25), modulus = 1900 * speed * speed;
  Material of_sand{1900, 2 * 1.3 * modulus, 0.3};
  if (friction > 0) of_sand.mohr_coulomb = MohrCoulomb({0, friction, 0, 0});
  return of_sand;
}

Material hysteretic(const Sand& sand) {
  Material of_sand = material(sand);
  of_sand.hysteretic = iwan_elements(backbone(hyperbola(6e-4, 1), 1.2e-6, 6e-3, 60));
  return of_sand;
}

double cycles(const Material& of, const Compaction& compaction, double ratio, const CyclicTest& test = {}) {
  return cycles_to_liquefaction(of, compaction, ratio, 1000, test).value_or(1000);
}

// The constant that was found gives 15 cycles within half a cycle, more at a lower ratio and fewer at a
// higher one.
void expect_calibrated(const Material& of, const Sand& sand, const CyclicTest& test = {}) {
  const auto [outcome, compaction, largest] = calibrated(of, sand.resistance, test);
  ASSERT_EQ(outcome, Calibration::kFound);
  EXPECT_EQ(compaction.c2, 0.4 / compaction.c1);
  EXPECT_NEAR(cycles(of, compaction, sand.resistance, test), 15, 0.5);
  EXPECT_GT(cycles(of, compaction, sand.resistance / 1.3, test), 30);
  EXPECT_LT(cycles(of, compaction, sand.resistance * 1.3, test), 7.5);
}

TEST(CyclicDriver, FindsTheCompactionOfAFrictionalSand) {
  for (const Sand& sand : kSands) expect_calibrated(material(sand), sand);
}

TEST(CyclicDriver, FindsTheCompactionAboveAHystereticLaw) {
  for (const Sand& sand : {kSands[0], kSands[1]}) expect_calibrated(hysteretic(sand), sand, {.steps = 50});
}

// Byrne's constants are for strains smaller than those of a hysteretic law, with which a loose sand liquefies
// in the second cycle.
TEST(CyclicDriver, ByrnesConstantsAreNotForHystereticStrains) {
  for (const Sand& sand : {kSands[0], kSands[1]}) {
    const Compaction byrne = from_blow_count(sand.blows);
    const double above_hysteretic = cycles(hysteretic(sand), byrne, sand.resistance);
    EXPECT_LT(above_hysteretic, 3);
    EXPECT_GT(cycles(material(sand), byrne, sand.resistance), 1.2 * above_hysteretic);
  }
}

// Elastic ground with friction alone has no stress of its own but the initial one, to which strains are in
// proportion: as long as it is the pressure that ends the test, the constant is the same for any.
TEST(CyclicDriver, DoesNotDependOnThePressureWithoutCohesion) {
  const Material of = material(kSands[1]);
  const double c1 = calibrated(of, kSands[1].resistance).compaction.c1;
  for (const double pressure : {50e3, 200e3})
    EXPECT_NEAR(calibrated(of, kSands[1].resistance, {.pressure = pressure}).compaction.c1, c1, 2e-3 * c1);
}

// Until ground under equal stresses yields, its strain is in proportion to the stress, and its pressure p
// falls by Byrne's sum. At R sv = p sin(phi) it yields, and flows until it has liquefied.
TEST(CyclicDriver, AgreesWithByrnesSumUntilItYields) {
  const Sand& sand = kSands[1];
  const Material of = material(sand);
  const auto [bulk, shear] = of.elasticity();
  const auto [c1, c2] = from_blow_count(sand.blows);
  const double pressure = 100e3, stress = sand.resistance * pressure, strain = stress / shear;
  double compaction = strain / 4 * c1, expected = 0.25;
  while ((pressure - bulk * compaction) * std::sin(kFriction) > stress) {
    compaction += strain / 2 * c1 * std::exp(-c2 * compaction / strain);
    expected += 0.5;
  }
  EXPECT_GT(expected, 30);
  EXPECT_NEAR(cycles(of, {c1, c2}, sand.resistance, {.k0 = 1}), expected, 0.75);
}

// Ground so soft that it would be strained by 4 % counts as liquefied at 3 %, which is 3/4 of the first
// quarter cycle.
TEST(CyclicDriver, CountsLargeStrainAsLiquefied) {
  const double ratio = 0.2, modulus = ratio * CyclicTest{}.pressure / 0.04;
  const Material soft{1900, 2 * 1.3 * modulus, 0.3};
  EXPECT_NEAR(cycles(soft, compaction(1e-6), ratio), 0.75 * 0.25, 0.01 * 0.25);
}

// Halving the steps of the strain changes the constant by less than 1 %.
TEST(CyclicDriver, ConvergesWithItsSteps) {
  for (const Sand& sand : kSands) {
    const double c1 = calibrated(material(sand), sand.resistance).compaction.c1;
    EXPECT_NEAR(calibrated(material(sand), sand.resistance, {.steps = 200}).compaction.c1, c1, 0.01 * c1);
  }
}

// A ratio that the ground does not bear without water either: the largest is that at which the stresses at
// rest turn into sheared ones of the same mean, M sin(phi) with M = (1 + K0)/2.
TEST(CyclicDriver, SaysWhatTheStrengthAllows) {
  const auto [outcome, compaction, largest] = calibrated(material(kSands[0]), 0.6);
  EXPECT_EQ(outcome, Calibration::kBeyondStrength);
  EXPECT_NEAR(largest, 0.75 * std::sin(kFriction), 0.02 * largest);
  EXPECT_EQ(calibrated(material(kSands[0]), 0.95 * largest).outcome, Calibration::kFound);
}

// Ground without friction keeps the difference of its stresses, whatever it compacts.
TEST(CyclicDriver, SaysThatGroundWithoutFrictionStaysFirm) {
  EXPECT_EQ(calibrated(material(kSands[0], 0), 0.1).outcome, Calibration::kFirm);
}

// A blow count stands for the constants that Byrne printed: 8.7 N^-1.25 and 0.4/C1.
TEST(CyclicDriver, KnowsByrnesConstants) {
  EXPECT_NEAR(from_blow_count(10).c1, 0.489, 1e-3);
  EXPECT_NEAR(from_blow_count(10).c2, 0.818, 1e-3);
}

}  // namespace
}  // namespace adit::fdm::test::cyclic_driver_test

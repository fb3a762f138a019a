// Requirements on ground with water at rest: what is stated is in equilibrium, below a water table, below the
// sea and beside free fields; the horizontal stress is that of the effective one; what the sea weighs; and
// what is not computed is refused in one sentence.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "protocol/ground/stated_stress.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/fdm_server/scenes.hpp"

namespace adit::fdm::test::water_rest_test {
namespace {

// 10 m of ground, of 1,800 kg/m^3 dry and 2,000 kg/m^3 wet.
const std::string kGround =
    "plane: PLANE_STRAIN material { young_modulus: 5e7 poisson_ratio: 0.3 density: 1800 "
    "pores { porosity: 0.4 saturated_density: 2000 } } ";
const std::string kDeep = "block { x_min: 0 x_max: 6 y_min: -10 y_max: 0 zones_x: 4 zones_y: 10 } ";
const std::string kHeld =
    "motions { where { y_max: -10 } velocity { x: 0 y: 0 } } body_loads { acceleration { y: -9.80665 } } ";
const std::string kFields = "free_field { left: true right: true } ";
const std::string kRollers =
    "motions { where { x_max: 0 } velocity { x: 0 } } motions { where { x_min: 6 } velocity { x: 0 } } ";

const std::string kPlane =
    "interfaces { name: 'plane' along { line { points { x: 0 y: -5 } points { x: 6 y: -5 } } } law { "
    "friction_angle: 0.5 } } ";

wire::Setup wet_setup(const std::string& water, const std::string& layers, const std::string& conditions,
                      const std::string& block = kDeep) {
  wire::Setup setup =
      setup_of(conditions, block, kGround + "water { " + water + " } initial_stress { " + layers + " } ");
  setup.set_alone(true);
  return setup;
}

// Values of the histories after some steps; ASSERTs that nothing moves.
std::vector<double> at_rest(const wire::Setup& setup) {
  FdmParticipant participant;
  wire::Model model;
  wire::Interface interface;
  set_up(participant, setup, model);
  participant.weigh({}, interface);
  const double dt = 0.5 * model.critical_dt(), kick = 9.8 * dt;
  wire::Predicted predicted;
  for (std::uint64_t step = 0; step <= 20; ++step) {
    wire::Advance advance;
    advance.set_step(step);
    advance.set_dt(dt);
    advance.set_want_histories(true);
    predicted.Clear();
    participant.advance(advance, predicted);
    EXPECT_LT(std::abs(predicted.histories(0)), 1e-10 * kick) << step;
  }
  return {predicted.histories().begin(), predicted.histories().end()};
}

const std::string kAsked =
    "histories { name: 'a' quantity: VELOCITY_Y at { x: 3 y: -1.5 } } "
    "histories { name: 'a' quantity: PORE_PRESSURE at { x: 3 y: -7.5 } } "
    "histories { name: 'a' quantity: EFFECTIVE_STRESS_YY at { x: 3 y: -7.5 } } "
    "histories { name: 'a' quantity: EFFECTIVE_STRESS_XX at { x: 3 y: -7.5 } } "
    "histories { name: 'a' quantity: STRESS_XX at { x: 3 y: -7.5 } } "
    "histories { name: 'a' quantity: STRESS_ZZ at { x: 3 y: -7.5 } } "
    "histories { name: 'a' quantity: PRESSURE_RATIO at { x: 3 y: -7.5 } } ";

constexpr double kG = protocol::kStandardGravity;

// A water table 4 m below the surface: 5.5 m from the table's zone boundary to the place.
TEST(WaterAtRest, BelowATable) {
  for (const std::string& sides : {kRollers, kFields})
    for (const std::string modulus : {"", " bulk_modulus: 2.2e9"}) {
      const auto values = at_rest(wet_setup("level: -4" + modulus,
                                            "layers { bottom: -4 density: 1800 k0: 0.5 } "
                                            "layers { bottom: -10 density: 2000 k0: 0.5 }",
                                            kHeld + sides + kAsked));
      const double pressure = 1000 * kG * 3.5, vertical = kG * (4 * 1800 + 3.5 * 2000) - pressure;
      EXPECT_NEAR(values[1], pressure, 1e-6);
      EXPECT_NEAR(values[2], -vertical, 1e-6);
      EXPECT_NEAR(values[3], -vertical / 2, 1e-6);
      EXPECT_NEAR(values[4], -vertical / 2 - pressure, 1e-6);
      EXPECT_NEAR(values[5], -0.3 * 1.5 * vertical - pressure, 1e-6) << "elastic zones are in plane strain";
      EXPECT_NEAR(values[6], 0, 1e-9);
    }
}

// The columns of free fields have the places of their side.
TEST(WaterAtRest, BelowTheLevelOfAPlace) {
  for (const std::string& sides : {kRollers, kFields}) {
    const auto values =
        at_rest(wet_setup("level: 0 bulk_modulus: 2.2e9 places { where { y_max: 0 } level: -4 }",
                          "layers { bottom: -4 density: 1800 k0: 0.5 } "
                          "layers { bottom: -10 density: 2000 k0: 0.5 }",
                          kHeld + sides + kAsked));
    EXPECT_NEAR(values[1], 1000 * kG * 3.5, 1e-6);
    EXPECT_NEAR(values[2], -kG * (4 * 1800 + 3.5 * 1000), 1e-6);
  }
}

// 30 m of sea add nothing to effective stresses.
TEST(WaterAtRest, BelowTheSea) {
  for (const std::string& sides : {kRollers, kFields}) {
    const auto values =
        at_rest(wet_setup("level: 30 bulk_modulus: 2.2e9", "layers { bottom: -10 density: 2000 k0: 0.5 }",
                          kHeld + sides + kAsked));
    EXPECT_NEAR(values[1], 1000 * kG * 37.5, 1e-6);
    EXPECT_NEAR(values[2], -kG * 7.5 * 1000, 1e-6);
    EXPECT_NEAR(values[3], -kG * 7.5 * 500, 1e-6);
  }
}

// A plane through wet ground bears its total stress, which is that of the layers.
TEST(WaterAtRest, AcrossAnInterface) {
  for (const std::string& sides : {kRollers, kFields, kRollers + "large_strain: true "}) {
    const auto values = at_rest(wet_setup(
        "level: 0 bulk_modulus: 2.2e9", "layers { bottom: -10 density: 2000 k0: 0.5 }",
        kHeld + sides + kPlane + kAsked +
            "histories { name: 'a' quantity: NORMAL_STRESS interface: 'plane' at { x: 3 y: -5 } } "
            "histories { name: 'a' quantity: SHEAR_STRESS interface: 'plane' at { x: 3 y: -5 } } "));
    EXPECT_NEAR(values[2], -kG * 7.5 * 1000, 1e-6);
    EXPECT_NEAR(values[7], -kG * 5 * 2000, 1e-6);
    EXPECT_NEAR(values[8], 0, 1e-6);
  }
}

// A light body in the place of wet ground takes off with exactly the weight that lacks, 2,000 - 500 kg/m^3.
TEST(WaterAtRest, LightBodyRisesByTheUnbalancedForce) {
  const wire::Setup setup =
      wet_setup("level: 0", "layers { bottom: -10 density: 2000 k0: 1 }",
                kHeld + kRollers +
                    "materials { where { x_min: 1.5 x_max: 4.5 y_min: -6 y_max: -3 } material { "
                    "young_modulus: 5e7 poisson_ratio: 0.3 density: 500 } } "
                    "histories { name: 'a' quantity: VELOCITY_Y at { x: 3 y: -4.5 } } ");
  FdmParticipant participant;
  wire::Model model;
  wire::Interface interface;
  set_up(participant, setup, model);
  participant.weigh({}, interface);
  constexpr double kStep = 1e-5;
  wire::Predicted predicted;
  for (std::uint64_t step = 0; step <= 1; ++step) {
    wire::Advance advance;
    advance.set_step(step);
    advance.set_dt(kStep);
    advance.set_want_histories(true);
    predicted.Clear();
    participant.advance(advance, predicted);
  }
  const double half_a_kick = kStep / 2 * kG * (2000 - 500) / 500;
  EXPECT_NEAR(predicted.histories(0), half_a_kick, 1e-10 * half_a_kick);
}

TEST(WaterAtRest, RefusesWhatItDoesNotCompute) {
  const std::string layers = "layers { bottom: -10 density: 2000 k0: 0.5 }";
  const auto refuse = [&](const wire::Setup& setup, const std::string& path, const std::string& says) {
    adit::test::expect_refusal(
        [&] {
          FdmParticipant participant;
          wire::Model model;
          set_up(participant, setup, model);
        },
        path, says);
  };
  refuse(wet_setup("level: -11", layers, kHeld), "water", "reaches no zone of a material with `pores`");
  refuse(wet_setup("level: 0 places { where { y_max: -5 } }", layers, kHeld), "water.places[0]",
         "either a `level` or a `pressure`");
  refuse(wet_setup("level: 0 places { where { y_max: -5 } level: -5 stage: 1 }", layers, kHeld),
         "water.places[0].stage", "no statics");
  wire::Setup filled = wet_setup(
      "level: 0", layers,
      kHeld +
          "materials { where { y_max: -5 } stage: 1 material { young_modulus: 5e7 poisson_ratio: 0.3 "
          "density: 1800 pores { porosity: 0.4 } } }");
  filled.mutable_scene()->mutable_statics();
  refuse(filled, "continuum.materials[0].stage", "dry or tight");
  wire::Setup light = wet_setup("level: 0", layers, kHeld);
  light.mutable_scene()->mutable_material()->mutable_pores()->set_saturated_density(1700);
  refuse(light, "material.pores.saturated_density", "at most 2200 kg/m^3, and no lighter");
  light.mutable_scene()->mutable_material()->mutable_pores()->set_saturated_density(2300);
  refuse(light, "material.pores.saturated_density", "at most 2200 kg/m^3, and no lighter");
  light.mutable_scene()->mutable_material()->mutable_pores()->set_saturated_density(390);
  light.mutable_scene()->mutable_material()->set_density(390);
  refuse(light, "material.pores", "no heavier than the water in it");
  wire::Setup layered = wet_setup("level: 0", layers, kHeld);
  layered.mutable_scene()->mutable_material()->mutable_pores()->set_conductivity_y(1e-5);
  refuse(layered, "material.pores.conductivity_y", "without `conductivity`");
  refuse(wet_setup("level: 0 places { where { x_min: 9 } level: -5 }", layers, kHeld),
         "water.places[0].where", "selects no zones");
}

}  // namespace
}  // namespace adit::fdm::test::water_rest_test

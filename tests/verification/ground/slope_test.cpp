// Requirement: ground below a gentle slope that starts from the weight of the layers above each place comes
// to rest with little movement, little of what it takes to put the weight on; a level line is the level
// surface; below the sea it bears its weight less that of the water.
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "coupler/stepping/statics.hpp"
#include "tests/support/local_participants.hpp"

namespace adit::slope_test {
namespace {

struct Rested {
  std::uint64_t steps;
  double largest;  // displacement [m]
};
const std::string kGround = "density: 2000 } ";
Rested rested(const std::string& stress, const std::string& models, const std::string& ground = kGround) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(
      "material { young_modulus: 1e8 poisson_ratio: 0.25 " + ground +
          "time { duration: 0.01 } statics { unbalanced_ratio: 1e-5 count_from_stage: 0 } " + stress + models,
      &scene));
  coupler::Model model = test::local_model(scene);
  coupler::Stepper stepper(model);
  Rested result{relax(model, stepper).steps, 0};
  stepper.step(0, {});
  for (const wire::Snapshot& snapshot : stepper.snapshots())
    for (const wire::Field& field : snapshot.pieces(0).point_fields())
      if (field.name() == "displacement_m")
        for (const double u : field.values()) result.largest = std::max(result.largest, std::abs(u));
  return result;
}

// 40 m by 20 m below a slope of 1 : 8.
const std::string kZones =
    "continuum { blocks { quadrilateral { corners { x: 0 y: -20 } corners { x: 40 y: -20 } corners { x: 40 "
    "y: 5 } corners { x: 0 "
    "y: 0 } } along { zones: 40 } across { zones: 20 } } body_loads { acceleration { y: -9.80665 } } "
    "motions { where { y_max: -20 } velocity { x: 0 y: 0 } } motions { where { x_max: 0 } velocity { x: 0 } "
    "} "
    "motions { where { x_min: 40 } velocity { x: 0 } } }";
const std::string kLayer = " layers { bottom: -20 density: 2000 k0: 0.5 } } ";

TEST(Slope, ComesToRestWithLittleMovement) {
  const Rested stated =
      rested("initial_stress { surface_line { x: 0 y: 0 } surface_line { x: 40 y: 5 }" + kLayer, kZones);
  const Rested from_nothing = rested("", kZones);
  EXPECT_LT(stated.largest, 0.1 * from_nothing.largest);
}

// Below the sea it moves as ground that weighs less by the weight of the water would in air.
TEST(Slope, HasItsBuoyantWeightBelowTheSea) {
  const std::string line = "initial_stress { surface_line { x: 0 y: 0 } surface_line { x: 40 y: 5 }";
  const Rested below_sea = rested("water { level: 12 } " + line + kLayer, kZones,
                                  "density: 2000 pores { porosity: 0.4 saturated_density: 2000 } } ");
  const Rested buoyant =
      rested(line + " layers { bottom: -20 density: 1000 k0: 0.5 } } ", kZones, "density: 1000 } ");
  EXPECT_NEAR(below_sea.largest, buoyant.largest, 0.01 * buoyant.largest);
}

TEST(Slope, OfNoInclinationIsLevelGround) {
  const std::string level =
      "continuum { block { x_min: 0 x_max: 8 y_min: -4 y_max: 0 zones_x: 8 zones_y: 8 } body_loads { "
      "acceleration { y: "
      "-9.80665 } } motions { where { y_max: -4 } velocity { x: 0 y: 0 } } motions { where { x_max: 0 } "
      "velocity { x: 0 } } "
      "motions { where { x_min: 8 } velocity { x: 0 } } }";
  const Rested line =
      rested("initial_stress { surface_line { x: 0 y: 0 } surface_line { x: 8 y: 0 }" + kLayer, level);
  EXPECT_LE(line.steps, 1u);
  EXPECT_LT(line.largest, 1e-12);
}

// In particles, too.
TEST(Slope, HoldsParticlesWithLittleMovement) {
  const std::string discs =
      "particles { packing { x_min: 0 x_max: 12 y_min: -6 y_max: 0.001 radius: 0.25 } bonds {} body_loads { "
      "acceleration { "
      "y: -9.80665 } } motions { where { y_max: -5.4 } velocity { x: 0 y: 0 } } motions { where { x_max: 0.6 "
      "y_min: -5.3 "
      "} velocity { x: "
      "0 } } motions { where { x_min: 11.4 y_min: -5.3 } velocity { x: 0 } } }";
  const Rested stated =
      rested("initial_stress { surface_line { x: 0 y: 0 } surface_line { x: 12 y: 0.01 }" + kLayer, discs);
  const Rested from_nothing = rested("", discs);
  EXPECT_LT(stated.largest, 0.1 * from_nothing.largest);
}

}  // namespace
}  // namespace adit::slope_test

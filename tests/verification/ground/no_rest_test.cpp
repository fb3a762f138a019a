// Requirement: statics of what cannot come to rest end within 20,000 steps and name what goes on moving,
// where, and how far; with every kind of damping, in the beginning and in a stage. What comes to rest slowly
// goes on.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "coupler/stepping/statics.hpp"
#include "protocol/errors.hpp"
#include "tests/support/local_participants.hpp"

namespace adit::no_rest_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// What ends the statics of a scene, and the steps until then; "" where it comes to rest.
struct End {
  std::string said;
  std::uint64_t steps = 0;
};
End statics_of(const std::string& damping, const std::string& models) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(
      "material { young_modulus: 1e8 poisson_ratio: 0.2 density: 2000 } time { duration: 0.01 } statics { " +
          damping + " } " + models,
      &scene))
      << models;
  coupler::Model model = test::local_model(scene);
  coupler::Stepper stepper(model);
  coupler::Statics statics(model, stepper);
  try {
    statics.run([](bool) {});
  } catch (const protocol::UserError& error) {
    EXPECT_EQ(error.path(), "statics");
    return {error.what(), statics.rest().steps};
  }
  return {"", statics.rest().steps};
}

const std::vector<std::string> kDampings{"", "damping: LOCAL", "damping: KINETIC", "damping: ADAPTIVE"};

void expect_named(const std::string& models, const testing::Matcher<const std::string&>& says) {
  for (const std::string& damping : kDampings) {
    const End end = statics_of(damping, models);
    EXPECT_THAT(end.said, says) << damping;
    EXPECT_LE(end.steps, 20'000u) << damping;
  }
}

constexpr const char* kWeight = "body_loads { acceleration { y: -10 } } ";

TEST(NoRest, OfABodyThatNothingHolds) {
  const std::string block =
      "continuum { block { x_min: 0 x_max: 4 y_min: 0 y_max: 2 zones_x: 8 zones_y: 4 } ";
  expect_named(block + kWeight + "}",
               AllOf(HasSubstr("cannot come to rest"), HasSubstr("nothing holds the model"),
                     HasSubstr("of `continuum`, from (")));
  expect_named(block + kWeight + "motions { where { x_max: 0 } velocity { x: 0 } } }",
               HasSubstr("nothing holds the model"));
}

// A slab that the excavation of a stage cuts off from held ground.
TEST(NoRest, OfAPartThatIsCutOff) {
  expect_named(std::string("continuum { blocks { name: 'ground' rectangle { x_min: 0 x_max: 8 y_min: 0 "
                           "y_max: 4 } along { zones: 16 } "
                           "across { zones: 8 } } blocks { name: 'slab' rectangle { x_min: 0 x_max: 8 y_min: "
                           "4 y_max: 5 } along { "
                           "zones: 16 } across { zones: 2 } } excavations { where { y_min: 3 y_max: 4 } "
                           "stage: 1 } motions { where { "
                           "y_max: 0 } velocity { x: 0 y: 0 } } ") +
                   kWeight + "}",
               AllOf(HasSubstr("rest, stage 1"), HasSubstr("group slab of `continuum`")));
}

TEST(NoRest, OfAGrainThatNoBondHolds) {
  std::string table = "x_m,y_m,radius_m\\n";
  for (int row = 0; row < 10; ++row)
    for (int column = 0; column < 20; ++column)
      table += fmt::format("{:.2f},{:.2f},0.1\\n", 0.2 * column, 0.2 * row);
  expect_named("particles { placed { path: 'discs.csv' content: '" + table +
                   "6,3,0.1\\n' } bonds {} contacts {} "
                   "motions { where { y_max: 0.01 } velocity { x: 0 y: 0 } } " +
                   kWeight + "}",
               HasSubstr("a particle that no bond holds of `particles`, from (6, 3) m"));
}

// The roof of a wide opening in ground without much strength falls in when the opening is made.
TEST(NoRest, OfARoofThatFallsInAStage) {
  const std::string ground =
      "continuum { material { young_modulus: 1e8 poisson_ratio: 0.2 density: 2000 mohr_coulomb { cohesion: "
      "2e3 "
      "friction_angle: 0.35 tension: 1e3 } } block { x_min: 0 x_max: 40 y_min: -20 y_max: 0 zones_x: 40 "
      "zones_y: 20 } " +
      std::string(kWeight) +
      "motions { where { y_max: -20 } velocity { x: 0 y: 0 } } motions { where { x_max: 0 } velocity { x: 0 "
      "} } "
      "motions { where { x_min: 40 } velocity { x: 0 } } "
      "excavations { where { x_min: 12 x_max: 28 y_min: -8 y_max: -4 } stage: 1 } } "
      "initial_stress { layers { bottom: -20 density: 2039.4 k0: 0.6 } }";
  expect_named(ground, AllOf(HasSubstr("rest, stage 1"), HasSubstr("of `continuum`, from (")));
}

// Soft ground that settles by a tenth of its height, in long swings, which local damping takes away slowly.
TEST(NoRest, IsNotSeenInWhatSettlesSlowly) {
  for (const std::string& damping : kDampings)
    EXPECT_EQ(
        statics_of(damping,
                   std::string("continuum { material { young_modulus: 3e6 poisson_ratio: 0.2 density: 2000 } "
                               "block { x_min: 0 x_max: 1 y_min: 0 y_max: 40 zones_x: 1 zones_y: 200 } "
                               "motions { where { y_max: 0 } velocity { x: 0 y: 0 } } ") +
                       kWeight + "}")
            .said,
        "")
        << damping;
}

// Nothing acts: at rest is at rest, without a share of nothing.
TEST(NoRest, IsNotSeenWhereNothingActs) {
  for (const std::string& models :
       {std::string("continuum { block { x_min: 0 x_max: 4 y_min: 0 y_max: 2 zones_x: 8 zones_y: 4 } }"),
        std::string("particles { packing { x_min: 0 x_max: 4 y_min: 0 y_max: 2 radius: 0.1 } }"),
        std::string(
            "particles { packing { x_min: 0 x_max: 4 y_min: 0 y_max: 2 radius: 0.1 } contacts {} }")}) {
    const End end = statics_of("", models);
    EXPECT_EQ(end.said, "");
    EXPECT_LE(end.steps, 10u);  // discs touch but for rounding
  }
}

}  // namespace
}  // namespace adit::no_rest_test

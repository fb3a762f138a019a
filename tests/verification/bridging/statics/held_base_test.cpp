// Requirement: statics hold a base where it lies in an overlap, too: ground and particles rest on a compliant
// base as on a rigid one, and stay at rest when the base is let go.
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "coupler/stepping/statics.hpp"
#include "tests/support/local_participants.hpp"

namespace adit::held_base_test {
namespace {

// The overlap, from 2 to 4 m, reaches down to the base, and its edge lies inside a zone. Beyond it the
// particles stand on rock that does not move.
scene::Scene strip(const std::string& base, const std::string& statics) {
  const std::string gravity = "body_loads { acceleration { y: -4 } } ";
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(
      "material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 } time { duration: 0.02 } "
      "statics { unbalanced_ratio: 1e-8 " +
          statics + " } continuum { block { x_min: -4 x_max: 4 y_min: 0 y_max: 4 zones_x: 18 zones_y: 8 } " +
          gravity +
          "histories { name: 's' quantity: STRESS_YY at { x: -1 y: 0.6 } } "
          "histories { name: 's' quantity: STRESS_XX at { x: 1.3 y: 2.1 } } "
          "histories { name: 'v' quantity: VELOCITY_Y at { x: 2.7 y: 4 } } base { " +
          base +
          " stress { amplitude: 0 } } } particles { packing { x_min: 1.8 x_max: 6.2 y_min: 0 y_max: 4 "
          "radius: 0.1443 } " +
          gravity +
          "motions { where { x_min: 4.2 y_max: 0.3 } velocity { x: 0 y: 0 } } "
          "histories { name: 'p' quantity: STRESS_YY at { x: 4.8 y: 1.5 } radius: 0.6 } } "
          "interface { overlap { particles_begin { x: 2 y: 0 } continuum_ends { x: 4 y: 0 } } }",
      &scene));
  return scene;
}

// Histories of the first step of time, and of the last.
struct Rested {
  std::vector<double> first, last;
};

Rested rested(const scene::Scene& scene) {
  coupler::Model model = test::local_model(scene);
  coupler::Stepper stepper(model);
  relax(model, stepper);
  Rested found;
  for (std::uint64_t n = 0; n <= model.steps; ++n) {
    stepper.step(n, {.energies = false, .histories = n == 0 || n == model.steps});
    if (n != 0 && n != model.steps) continue;
    for (const coupler::Participant& participant : model.participants) {
      const auto& values = participant.prediction().histories();
      auto& to = n == 0 ? found.first : found.last;
      to.insert(to.end(), values.begin(), values.end());
    }
  }
  return found;
}

class HeldBase : public testing::TestWithParam<const char*> {};

TEST_P(HeldBase, CarriesTheSameWhetherItWillYieldOrNot) {
  scene::Scene held = strip("kind: COMPLIANT", GetParam());
  held.mutable_continuum()->clear_base();
  auto& motion = *held.mutable_continuum()->add_motions();
  motion.mutable_where()->set_y_max(0);
  motion.mutable_velocity()->set_x(0);
  motion.mutable_velocity()->set_y(0);
  const Rested stiff = rested(held), soft = rested(strip("kind: COMPLIANT", GetParam()));
  ASSERT_EQ(stiff.first.size(), 4u);
  for (const std::size_t stress : {0, 1, 3}) {
    EXPECT_NEAR(soft.first[stress], stiff.first[stress], 1e-4 * std::abs(stiff.first[0])) << stress;
    EXPECT_NEAR(soft.last[stress], stiff.first[stress], 1e-4 * std::abs(stiff.first[0])) << stress;
  }
  EXPECT_NEAR(stiff.first[0], -2000 * 4 * 3.4, 0.05 * 2000 * 4 * 3.4) << "the weight above";
  EXPECT_NEAR(soft.last[2], 0, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Masses, HeldBase, testing::Values("", "scale_masses: false", "damping: LOCAL"));

}  // namespace
}  // namespace adit::held_base_test

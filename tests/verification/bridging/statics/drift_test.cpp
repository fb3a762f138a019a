// Requirement: a model that statics left out of equilibrium does not drift when its edges are let go: what
// its edges are held by balances loads and stresses, not the inertia of the last step. What statics measured
// a step before stands for what is unbalanced when they end: a few percent of the drift are left.
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "coupler/stepping/statics.hpp"
#include "tests/support/local_participants.hpp"
#include "tests/support/overlaps.hpp"

namespace adit::drift_test {
namespace {

constexpr double kDuration = 1;  // [s]: P waves cross the model 8 times

const char* const kGround = "body_loads { acceleration { y: -10 } } ";
const char* const kProbe =
    "histories { name: 'a' quantity: DISPLACEMENT_Y at { x: 8 y: 5 } } "
    "histories { name: 'b' quantity: DISPLACEMENT_X at { x: 8 y: 5 } } ";

scene::Scene settling(const std::string& models) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(
      "material { young_modulus: 5e7 poisson_ratio: 0.2 density: 2000 } time { duration: 1 dt_factor: 0.9 } "
      "statics { unbalanced_ratio: 1e-2 } " +
          models,
      &scene))
      << models;
  return scene;
}

// Velocity over the second half of the duration, when what was unbalanced has left through the dashpots, as a
// share of the drift that statics foretold.
double late_share(const scene::Scene& scene) {
  coupler::Model model = test::local_model(scene);
  coupler::Stepper stepper(model);
  const coupler::Rest rest = relax(model, stepper);
  const double drift = std::hypot(rest.drift.x, rest.drift.y);
  EXPECT_GT(drift, 1e-3) << "too little is unbalanced to drift";
  std::vector<double> middle, end;
  for (std::uint64_t n = 0; n <= model.steps; ++n) {
    stepper.step(n, {.energies = false, .histories = n == model.steps / 2 || n == model.steps});
    for (const coupler::Participant& participant : model.participants) {
      const auto& values = participant.prediction().histories();
      auto& to = n == model.steps ? end : middle;
      if (n == model.steps / 2 || n == model.steps) to.insert(to.end(), values.begin(), values.end());
    }
  }
  EXPECT_EQ(end.size(), 2u);
  return std::hypot(end[0] - middle[0], end[1] - middle[1]) / (kDuration / 2) / drift;
}

TEST(Drift, OfACoupledModelOnACompliantBaseIsTakenOut) {
  EXPECT_LT(
      late_share(settling(
          std::string(
              "continuum { block { x_min: 0 x_max: 16 y_min: 0 y_max: 10 zones_x: 32 zones_y: 20 } ") +
          kGround +
          "free_field { left: true right: true } base { kind: COMPLIANT stress { amplitude: 0 } } } "
          "particles { packing { x_min: 2 x_max: 14 y_min: 0 y_max: 10 radius: 0.1 } " +
          kGround + kProbe + "} interface { overlap { " + test::ring(test::circle(8, 5, 2.2), 2) + " } } ")),
      0.05);
}

TEST(Drift, OfParticlesOnQuietEdgesIsTakenOut) {
  EXPECT_LT(late_share(settling(std::string("particles { engine: GENERAL packing { x_min: 0 x_max: 16 y_min: "
                                            "0 y_max: 10 radius: 0.2 } bonds {} ") +
                                kGround + kProbe + "quiet { where { y_max: 0.6 } side: LOWER } }")),
            0.05);
}

}  // namespace
}  // namespace adit::drift_test

// Requirement: discs come to rest under their weight, bonded on quiet edges and loose between walls, and stay
// there when time begins; a step above the critical one is refused.
#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "coupler/participants/time_step.hpp"
#include "coupler/stepping/statics.hpp"
#include "coupler/stepping/stepper.hpp"
#include "protocol/errors.hpp"
#include "tests/support/local_participants.hpp"
#include "tests/support/refusals.hpp"

namespace adit::rest_test {
namespace {

constexpr double kWidth = 10, kHeight = 6, kGravity = 10;

scene::Scene heap(const std::string& held) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(
      "material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 } time { duration: 0.02 } statics {} "
      "particles { random_packing { x_min: 0 x_max: 10 y_min: 0 y_max: 6 radius_min: 0.2 radius_max: 0.3 "
      "stress: 1e5 } "
      "contacts { normal_stiffness: 1e9 shear_stiffness: 5e8 friction: 0.5 } "
      "body_loads { acceleration { y: -10 } } "
      "histories { name: 'top' quantity: VELOCITY_Y at { x: 5 y: 5.7 } } "
      "histories { name: 'top' quantity: DISPLACEMENT_Y at { x: 5 y: 5.7 } } " +
          held + " }",
      &scene));
  return scene;
}

const char* const kOnQuietEdges =
    "bonds { parallel { normal_stiffness: 2e9 shear_stiffness: 1e9 } } "
    "quiet { where { y_max: 0.4 } side: LOWER } quiet { where { x_max: 0.4 } side: LEFT } "
    "quiet { where { x_min: 9.6 } side: RIGHT }";
const char* const kBetweenWalls =
    "walls { name: 'floor' from { x: -5 y: 0 } to { x: 15 y: 0 } } "
    "walls { name: 'left' from { x: 0 y: 0 } to { x: 0 y: 10 } } "
    "walls { name: 'right' from { x: 10 y: 0 } to { x: 10 y: 10 } }";

TEST(DiscsAtRest, StayWhenTimeBegins) {
  for (const char* held : {kOnQuietEdges, kBetweenWalls}) {
    coupler::Model model = test::local_model(heap(held));
    coupler::Stepper stepper(model);
    relax(model, stepper);
    for (std::uint64_t n = 0; n <= model.steps; ++n) stepper.step(n, {.energies = true, .histories = true});
    const wire::Predicted& predicted = model.participants[0].prediction();
    // In free fall it would reach g t and g t^2 / 2.
    const double t = static_cast<double>(model.steps) * model.dt;
    EXPECT_LT(std::abs(predicted.histories(0)), 1e-4 * kGravity * t) << held;
    EXPECT_LT(std::abs(predicted.histories(1)), 1e-4 * kGravity * t * t / 2) << held;
    EXPECT_LT(stepper.ledger().max_drift(), 1e-10);
  }
}

TEST(DiscsAtRest, RefuseAStepAboveTheCriticalOne) {
  scene::Scene scene = heap(kBetweenWalls);
  coupler::Model model = test::local_model(scene);
  scene.mutable_time()->set_dt(1.01 * model.dt / scene.time().dt_factor());
  test::expect_refusal([&] { test::local_model(scene); }, "time.dt", "above");
}

}  // namespace
}  // namespace adit::rest_test

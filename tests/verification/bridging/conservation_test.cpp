// Requirement: the interface creates neither momentum nor energy. A free bar, half zones and half particles,
// is pushed on its zones. Both solves keep linear momentum except for rounding errors; the consistent one
// keeps energy in every step, the lumped one never gains any.
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "coupler/stepping/stepper.hpp"
#include "tests/support/local_participants.hpp"
#include "tests/support/momentum.hpp"

namespace adit::conservation_test {
namespace {

constexpr double kDensity = 2000, kForceX = 3e5, kForceY = 1e5;

scene::Scene free_bar(scene::Solve solve) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(R"(
    plane: PLANE_STRESS
    material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 }
    time { duration: 0.02 }
    continuum {
      block { x_min: 0 x_max: 4 y_min: 0 y_max: 1 zones_x: 8 zones_y: 2 }
      edge_loads { where { x_max: 0 } force { x: 3e5 y: 1e5 } time { sine { frequency: 100 end: 0.005 } } }
    }
    particles { packing { x_min: 0 x_max: 4 y_min: 0 y_max: 1 radius: 0.05 } }
    interface { overlap { particles_begin { x: 1.3 y: 0 } continuum_ends { x: 2.7 y: 0 } } }
  )",
                                                            &scene));
  scene.mutable_interface()->set_solve(solve);
  return scene;
}

class Conservation : public testing::TestWithParam<scene::Solve> {};

TEST_P(Conservation, MomentumIsTheImpulseOfTheLoad) {
  coupler::Model model = test::local_model(free_bar(GetParam()));
  coupler::Stepper stepper(model);
  double impulse = 0;  // of a load of 1 N, as the scheme sums it
  for (std::uint64_t n = 0; n <= model.steps; ++n) {
    stepper.step(n, {});
    const double t = static_cast<double>(n) * model.dt;
    if (t <= 0.005) impulse += (n == 0 ? 0.5 : 1.0) * model.dt * std::sin(2 * std::numbers::pi * 100 * t);
  }
  const auto found = test::momentum(stepper.snapshots(), kDensity);
  EXPECT_NEAR(found[0], kForceX * impulse, 1e-10 * kForceX * impulse);
  EXPECT_NEAR(found[1], kForceY * impulse, 1e-10 * kForceX * impulse);
}

// After the load, energy may only stay (consistent) or fall (lumped) from one look at it to the next.
TEST_P(Conservation, EnergyIsKeptOrLostButNeverMade) {
  coupler::Model model = test::local_model(free_bar(GetParam()));
  coupler::Stepper stepper(model);
  double before = 0, peak = 0;
  for (std::uint64_t n = 0; n <= model.steps; ++n) {
    stepper.step(n, {.energies = true});
    const double unexplained = stepper.ledger().unexplained();
    peak = std::max(peak, stepper.ledger().stored());
    EXPECT_LE(unexplained - before, 1e-6 * peak) << "step " << n;
    before = unexplained;
  }
  if (GetParam() == scene::CONSISTENT) {
    EXPECT_LE(stepper.ledger().max_drift(), 1e-5);
    EXPECT_LE(stepper.ledger().max_constraint_residual(), 1e-12);
  } else {
    EXPECT_LT(stepper.ledger().kept(), 1);
  }
}

// Each side's own balance closes once the work of the multipliers is counted, so no energy hides between
// them.
TEST_P(Conservation, EachSideBalancesWithTheWorkOfTheMultipliers) {
  coupler::Model model = test::local_model(free_bar(GetParam()));
  coupler::Stepper stepper(model);
  for (std::uint64_t n = 0; n <= model.steps; ++n) stepper.step(n, {.energies = n == model.steps});
  for (const auto& participant : stepper.ledger().energies()) {
    const double stored = participant.kinetic + participant.strain;
    EXPECT_NEAR(stored, participant.external_work + participant.multiplier_work, 1e-5 * stored);
  }
}

INSTANTIATE_TEST_SUITE_P(BothSolves, Conservation, testing::Values(scene::CONSISTENT, scene::LUMPED),
                         [](const auto& info) { return scene::Solve_Name(info.param); });

// Requirement: the ledger closes also where a prescribed motion of the grid lies in the overlap and its
// reaction takes up the multipliers' impulses.
TEST(Conservation, PrescribedMotionInTheOverlapIsBooked) {
  scene::Scene scene = free_bar(scene::CONSISTENT);
  auto& motion = *scene.mutable_continuum()->add_motions();
  motion.mutable_where()->set_x_min(1.9);
  motion.mutable_where()->set_x_max(2.1);
  motion.mutable_where()->set_y_max(0);
  motion.mutable_velocity()->set_x(0.4);
  motion.mutable_velocity()->set_y(0.3);
  motion.mutable_time()->mutable_sine()->set_frequency(150);
  coupler::Model model = test::local_model(scene);
  coupler::Stepper stepper(model);
  for (std::uint64_t n = 0; n <= model.steps; ++n) stepper.step(n, {.energies = true});
  EXPECT_LE(stepper.ledger().max_drift(), 1e-5);
}

// Requirement: without load nothing moves, exactly.
TEST(Conservation, RestStaysRest) {
  scene::Scene scene = free_bar(scene::CONSISTENT);
  scene.mutable_continuum()->clear_edge_loads();
  coupler::Model model = test::local_model(scene);
  coupler::Stepper stepper(model);
  for (std::uint64_t n = 0; n <= 200; ++n) stepper.step(n, {.energies = true});
  EXPECT_EQ(stepper.ledger().stored(), 0);
  for (const coupler::Participant& participant : model.participants)
    for (const double velocity : participant.predicted) EXPECT_EQ(velocity, 0);
}

}  // namespace
}  // namespace adit::conservation_test

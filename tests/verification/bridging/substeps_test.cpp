// Requirement: particles may take m steps in one step of the continuum (shared_kick.hpp). The consistent
// solve keeps energy and the others only lose it, for every m and any ratio of stiffnesses. The motion agrees
// with that of equal steps to second order.
#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "coupler/stepping/stepper.hpp"
#include "tests/support/local_participants.hpp"
#include "tests/support/refusals.hpp"

namespace adit::substeps_test {
namespace {

// A bar, zones of 0.5 m at its pushed end, particles at its fixed end.
scene::Scene bar(unsigned substeps, scene::Solve solve = scene::CONSISTENT) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(R"(
    plane: PLANE_STRESS
    material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 }
    time { duration: 0.04 }
    continuum {
      block { x_min: 0 x_max: 4 y_min: 0 y_max: 1 zones_x: 8 zones_y: 2 }
      edge_loads { where { x_max: 0 } force { x: 3e5 y: 1e5 } time { sine { frequency: 100 end: 0.005 } } }
      histories { name: "tip" quantity: DISPLACEMENT_Y at { x: 0 y: 0.5 } }
    }
    particles {
      packing { x_min: 0 x_max: 4 y_min: 0 y_max: 1 radius: 0.05 }
      motions { where { x_min: 3.92 } velocity { x: 0 y: 0 } spin: 0 }
      histories { name: "end" quantity: DISPLACEMENT_Y at { x: 3.5 y: 0.5 } }
    }
    interface { overlap { particles_begin { x: 1.3 y: 0 } continuum_ends { x: 2.7 y: 0 } } }
  )",
                                                            &scene));
  scene.mutable_time()->set_substeps(substeps);
  scene.mutable_interface()->set_solve(solve);
  return scene;
}

struct Substeps : testing::TestWithParam<unsigned> {};

TEST_P(Substeps, KeepEnergyOverManyPeriods) {
  scene::Scene scene = bar(GetParam());
  scene.mutable_time()->set_duration(0.5);
  scene.mutable_time()->set_dt_factor(0.9);
  coupler::Model model = test::local_model(scene);
  coupler::Stepper stepper(model);
  for (std::uint64_t n = 0; n <= model.steps; ++n) stepper.step(n, {.energies = true});
  EXPECT_LE(stepper.ledger().max_drift(), 5e-5);
  EXPECT_LE(stepper.ledger().max_constraint_residual(), 1e-12);
}

TEST_P(Substeps, LoseEnergyOnlyWithTheOtherSolves) {
  for (const scene::Solve solve : {scene::LUMPED, scene::SPLIT}) {
    coupler::Model model = test::local_model(bar(GetParam(), solve));
    coupler::Stepper stepper(model);
    for (std::uint64_t n = 0; n <= model.steps; ++n) stepper.step(n, {.energies = true});
    EXPECT_LT(stepper.ledger().kept(), 1 + 1e-3) << scene::Solve_Name(solve);
    EXPECT_GT(stepper.ledger().kept(), 0.5) << scene::Solve_Name(solve);
  }
}

TEST_P(Substeps, SurviveAContrastOfStiffness) {
  for (const double factor : {1e-3, 1e3}) {
    scene::Scene scene = bar(GetParam());
    *scene.mutable_continuum()->mutable_material() = scene.material();
    scene.mutable_continuum()->mutable_material()->set_young_modulus(factor * 1e9);
    scene.mutable_time()->set_dt_factor(0.9);
    coupler::Model model = test::local_model(scene);
    model.steps = std::min<std::uint64_t>(model.steps, 3000);
    coupler::Stepper stepper(model);
    for (std::uint64_t n = 0; n <= model.steps; ++n) stepper.step(n, {.energies = true});
    EXPECT_LE(stepper.ledger().max_drift(), 1e-6) << factor;
  }
}

// Requirement: the energy closes from the first step on, of the model and of each participant, whatever acts
// in the overlap: loads, weight, a moving base, quiet boundaries.
TEST_P(Substeps, KeepTheLedgerClosedAtEveryStepUnderLoads) {
  scene::Scene scene = bar(GetParam());
  ASSERT_TRUE(google::protobuf::TextFormat::MergeFromString(R"(
    continuum {
      edge_loads { where { x_max: 2.2 y_max: 0 } force { y: 1e6 } time { sine { frequency: 1000 end: 5e-4 } } }
      body_loads { acceleration { x: 3 y: -10 } }
      quiet { where { x_max: 2.5 y_max: 0 } }
    }
    particles { body_loads { acceleration { x: 3 y: -10 } } }
  )",
                                                            &scene));
  coupler::Model model = test::local_model(scene);
  coupler::Stepper stepper(model);
  std::vector<double> at_start;
  for (std::uint64_t n = 0; n <= 200; ++n) {
    stepper.step(n, {.energies = true});
    const coupler::Ledger& ledger = stepper.ledger();
    for (std::size_t s = 0; s < 2; ++s) {
      const coupler::ParticipantEnergies& energies = ledger.energies()[s];
      if (n == 0) at_start.push_back(energies.balance());
      ASSERT_NEAR(energies.balance(), at_start[s], 1e-5 * energies.turnover()) << "step " << n << ", " << s;
    }
  }
  EXPECT_LE(stepper.ledger().max_drift(), 1e-6);  // as with equal steps
}

INSTANTIATE_TEST_SUITE_P(Even, Substeps, testing::Values(2U, 4U, 8U));

// Displacements of both ends at equal times.
std::vector<double> history(scene::Scene scene, double grid_step) {
  scene.mutable_time()->set_dt(grid_step / scene.time().substeps());
  coupler::Model model = test::local_model(scene);
  coupler::Stepper stepper(model);
  const auto stride = static_cast<std::uint64_t>(std::lround(0.002 / model.dt));
  std::vector<double> values;
  for (std::uint64_t n = 0; n <= model.steps; ++n) {
    stepper.step(n, {.histories = n % stride == 0});
    if (n % stride == 0)
      for (const coupler::Participant& participant : model.participants)
        values.push_back(participant.prediction().histories(0));
  }
  return values;
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double squares = 0, norm = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    squares += (a[i] - b[i]) * (a[i] - b[i]);
    norm += b[i] * b[i];
  }
  return std::sqrt(squares / norm);
}

TEST(Substeps, AreOfSecondOrder) {
  const std::vector<double> reference = history(bar(1), 0.002 / 1024);
  for (const unsigned m : {1U, 2U, 4U}) {
    const double coarse = difference(history(bar(m), 0.002 / 32), reference);
    const double fine = difference(history(bar(m), 0.002 / 64), reference);
    EXPECT_GE(std::log2(coarse / fine), 1.8) << m << " substeps: " << coarse << ", " << fine;
    EXPECT_LE(fine, 1e-2) << m;
  }
}

void expect_refusal(const scene::Scene& scene, const std::string& text) {
  adit::test::expect_refusal([&] { test::local_model(scene); }, "time.substeps", text);
}

TEST(Substeps, AreRefusedWhereTheContinuumHasNoMiddleToMoveIn) {
  expect_refusal(bar(3), "even number");
  scene::Scene alone = bar(2);
  alone.clear_interface();
  alone.clear_particles();
  expect_refusal(alone, "joined to particles");
}

// Requirement: the automatic choice follows the two critical steps.
TEST(Substeps, AreChosenFromTheCriticalSteps) {
  const coupler::Model model = test::local_model(bar(0));
  EXPECT_EQ(model.substeps % 2, 0U);
  EXPECT_LE(model.dt, 0.4 * model.participants[0].model.critical_dt());
  EXPECT_GT(model.dt * (model.substeps + 2.0) / model.substeps,
            0.4 * model.participants[0].model.critical_dt());
  EXPECT_NEAR(model.dt * static_cast<double>(model.steps), 0.04, 1e-15);
}

// Requirement: where two models of one kind are joined, which substeps do not go with, the choice is 1.
TEST(Substeps, AreNotChosenWhereTwoModelsOfOneKindAreJoined) {
  scene::Scene scene = bar(0);
  scene.mutable_continuum()->clear_edge_loads();
  *scene.add_interfaces()->mutable_overlap() = scene.interface().overlap();
  scene.clear_interface();
  ASSERT_TRUE(google::protobuf::TextFormat::MergeFromString(R"(
    continuum { block { x_min: -1 zones_x: 10 } }
    regions {
      name: "far"
      continuum { block { x_min: -4 x_max: 0 y_min: 0 y_max: 1 zones_x: 8 zones_y: 2 } }
    }
    interfaces {
      outer: "far" inner: "continuum"
      overlap { particles_begin { x: -1 y: 0 } continuum_ends { x: 0 y: 0 } }
    }
  )",
                                                            &scene));
  scene.mutable_interfaces(0)->set_outer("continuum");
  scene.mutable_interfaces(0)->set_inner("particles");
  EXPECT_EQ(test::local_model(scene).substeps, 1U);
}

}  // namespace
}  // namespace adit::substeps_test

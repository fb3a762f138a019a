// Loads, body loads, prescribed motions: what they do, and that their work closes the energy ledger.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dem_server/model/calibration.hpp"
#include "protocol/errors.hpp"
#include "tests/unit/dem_server/cantilever_scene.hpp"

namespace adit::dem::conditions_test {
namespace {

using test::cantilever_scene;
using test::InProcessRun;

scene::Scene free_block() {
  auto scene = cantilever_scene();
  scene.mutable_particles()->clear_loads();
  scene.mutable_particles()->clear_motions();
  scene.mutable_particles()->mutable_packing()->set_x_max(1);
  scene.mutable_particles()->mutable_histories(0)->mutable_at()->set_x(0.5);
  return scene;
}

// What must stay as it was at step 0, where v(-1/2) = -v(1/2) makes the kinetic energy of what is loaded
// slightly negative.
double ledger(const wire::Energies& e) {
  return e.kinetic() + e.strain() + e.released() - e.external_work();
}

// A free block under gravity falls by g t^2 / 2 and keeps its energy: its work is the weight's.
TEST(Conditions, FreeFall) {
  auto scene = free_block();
  scene.mutable_particles()->add_body_loads()->mutable_acceleration()->set_y(-9.81);
  InProcessRun run(scene);
  const double start = ledger(run.advance().energies());
  for (int n = 1; n <= 100; ++n) run.advance();
  const double t = 100 * run.dt;
  EXPECT_NEAR(run.predicted.histories(0), -9.81 * t * t / 2, 1e-12 * t * t);
  const double mass =
      static_cast<double>(run.interface.particles()) * cell_mass(2500, test::kCantileverRadius);
  EXPECT_NEAR(run.predicted.energies().external_work(), mass * 9.81 * 9.81 * t * t / 2,
              1e-3 * mass * 9.81 * 9.81 * t * t / 2);
  EXPECT_NEAR(ledger(run.predicted.energies()), start, 1e-12 * run.predicted.energies().external_work());
  EXPECT_LT(run.predicted.strongest(0).force(), 1e-3);
}

// The acceleration is that of the step itself from the first on.
TEST(Conditions, AccelerationIsCentredAtTheStep) {
  auto scene = free_block();
  auto& body = *scene.mutable_particles()->add_body_loads();
  body.mutable_acceleration()->set_y(-10);
  for (const double value : {1.0, 2.0}) {
    body.mutable_time()->mutable_table()->add_time(value - 1);
    body.mutable_time()->mutable_table()->add_value(value);
  }
  scene.mutable_particles()->mutable_histories(0)->set_quantity(scene::ACCELERATION_Y);
  InProcessRun run(scene);
  for (int n = 0; n <= 100; ++n) EXPECT_NEAR(run.advance().histories(0), -10 * (1 + n * run.dt), 1e-8);
}

// A body load acts on the weighted mass: a weighted block falls as fast as an unweighted one.
TEST(Conditions, BodyLoadActsOnTheWeightedMass) {
  auto scene = free_block();
  scene.mutable_particles()->add_body_loads()->mutable_acceleration()->set_x(2);
  wire::Weights weights;
  weights.set_floor(1e-3);
  for (int k = 0; k < InProcessRun(scene).model.sample_points_size() / 2; ++k) weights.add_weights(0.25);
  scene.mutable_particles()->mutable_histories(0)->set_quantity(scene::DISPLACEMENT_X);
  InProcessRun run(scene, weights);
  for (int n = 0; n <= 100; ++n) run.advance();
  EXPECT_NEAR(run.predicted.histories(0), std::pow(100 * run.dt, 2), 1e-12);
}

// A load is a total: shared equally, whatever it selects, it gives the block's mass its momentum.
TEST(Conditions, LoadIsSharedEqually) {
  auto scene = free_block();
  scene.mutable_particles()->add_loads()->mutable_where();
  scene.mutable_particles()->mutable_loads(0)->mutable_force()->set_y(1000);
  InProcessRun run(scene);
  for (int n = 0; n <= 100; ++n) run.advance();
  const double mass =
      static_cast<double>(run.interface.particles()) * cell_mass(2500, test::kCantileverRadius);
  const double t = 100 * run.dt;
  EXPECT_NEAR(run.predicted.histories(0), 1000 / mass * t * t / 2, 1e-12 * t);
  EXPECT_LT(run.predicted.strongest(0).force(), 1e-3);
}

// Particles with a prescribed velocity follow it at the half steps and ignore loads.
TEST(Conditions, PrescribedVelocityIsFollowed) {
  auto scene = free_block();
  auto& load = *scene.mutable_particles()->add_loads();
  load.mutable_where();
  load.mutable_force()->set_y(1e6);
  auto& motion = *scene.mutable_particles()->add_motions();
  motion.mutable_where();
  motion.mutable_velocity()->set_y(0.5);
  auto& sine = *motion.mutable_time()->mutable_sine();
  sine.set_frequency(100);
  InProcessRun run(scene);
  double expected = 0;
  run.advance();
  for (int n = 1; n <= 200; ++n) {
    run.advance();
    expected += run.dt * 0.5 * std::sin(2 * std::numbers::pi * 100 * (n - 0.5) * run.dt);
    ASSERT_NEAR(run.predicted.histories(0), expected, 1e-14);
  }
}

// What comes to a velocity at once has no kinetic energy before, and afterwards gets just that by the work of
// its motion, in either engine.
TEST(Conditions, MotionThatBeginsAtOnceTakesItsKineticEnergyAsWork) {
  for (const auto engine : {scene::Particles::LATTICE, scene::Particles::GENERAL}) {
    auto scene = free_block();
    scene.mutable_particles()->set_engine(engine);
    auto& motion = *scene.mutable_particles()->add_motions();
    motion.mutable_where();
    motion.mutable_velocity()->set_x(0.5);
    motion.set_spin(0);
    InProcessRun run(scene);
    const double expected = run.interface.mass() * 0.5 * 0.5 / 2;
    for (int n = 0; n < 3; ++n) {
      const auto& energies = run.advance().energies();
      EXPECT_NEAR(energies.kinetic(), n == 0 ? 0 : expected, 1e-12 * expected) << n;
      EXPECT_NEAR(energies.external_work(), n == 0 ? 0 : expected, 1e-12 * expected) << n;
    }
  }
}

// The ledger closes with loads, a body load, a shaken support and a spun column at once: the work of loads
// and reactions is what the block holds. What is left is the lattice's geometric nonlinearity.
TEST(Conditions, EnergyLedgerClosesUnderLoadsAndMotions) {
  auto scene = cantilever_scene();
  scene.mutable_particles()->add_body_loads()->mutable_acceleration()->set_y(-9.81);
  scene.mutable_particles()->mutable_loads(0)->mutable_force()->set_y(1e3);
  auto& fixed = *scene.mutable_particles()->mutable_motions(0);
  fixed.clear_spin();
  fixed.mutable_velocity()->set_y(1e-3);
  fixed.mutable_time()->mutable_sine()->set_frequency(300);
  auto& spun = *scene.mutable_particles()->add_motions();
  spun.mutable_where()->set_x_max(test::kCantileverRadius);
  spun.mutable_velocity();
  spun.set_spin(0.01);
  InProcessRun run(scene);
  const double start = ledger(run.advance().energies());
  double worst = 0, peak = 0;
  for (int n = 1; n <= 1500; ++n) {
    const auto& energies = run.advance().energies();
    worst = std::max(worst, std::abs(ledger(energies) - start));
    peak = std::max(peak, energies.kinetic() + energies.strain());
  }
  EXPECT_GT(peak, 0.1);
  EXPECT_LT(worst, 1e-5 * peak);
}

// Histories come in the scene's order from the nearest particle.
TEST(Conditions, HistoriesReadTheNearestParticle) {
  auto scene = free_block();
  auto& particles = *scene.mutable_particles();
  auto& motion = *particles.add_motions();
  motion.mutable_where()->set_x_min(0.5);
  motion.mutable_velocity()->set_x(2);
  motion.mutable_velocity()->set_y(-3);
  particles.clear_histories();
  for (const auto quantity :
       {scene::VELOCITY_Y, scene::DISPLACEMENT_X, scene::VELOCITY_X, scene::DISPLACEMENT_Y}) {
    auto& history = *particles.add_histories();
    history.set_name("corner");
    history.set_quantity(quantity);
    history.mutable_at()->set_x(0.9);
    history.mutable_at()->set_y(0.5);
  }
  InProcessRun run(scene);
  run.advance();
  run.advance();
  EXPECT_THAT(run.predicted.histories(), testing::ElementsAre(-3, 2 * run.dt, 2, -3 * run.dt));
}

}  // namespace
}  // namespace adit::dem::conditions_test

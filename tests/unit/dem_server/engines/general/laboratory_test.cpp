// Requirement: a body of cells has the strengths that its material states, without calibration, whatever the
// size of the cells.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/dem_server/in_process_run.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::laboratory_test {
namespace {

constexpr double kWidth = 0.1, kHeight = 0.2;                             // [m]
constexpr double kTensile = 2.5e6, kCompressive = 39e6, kEnergy = 100.0;  // [Pa], [J/m^2]

// A specimen of concrete between two platens that let go across, the upper one moving by this speed [m/s].
scene::Scene specimen(double size, double speed, std::uint64_t seed) {
  auto scene = test::empty_scene();
  auto& material = *scene.mutable_material();
  material.set_young_modulus(30e9);
  material.set_density(2400);
  auto& fracture = *material.mutable_fracture();
  fracture.set_tensile_strength(kTensile);
  fracture.set_fracture_energy(kEnergy);
  fracture.set_compressive_strength(kCompressive);
  auto& particles = *scene.mutable_particles();
  auto& cells = *particles.mutable_cells();
  cells.set_x_min(0);
  cells.set_x_max(kWidth);
  cells.set_y_min(-size);
  cells.set_y_max(kHeight + size);
  cells.set_size(size);
  cells.set_seed(seed);
  particles.mutable_damping()->set_viscous(200);
  for (const bool upper : {false, true}) {
    auto& group = *particles.add_groups();
    group.set_name(upper ? "upper" : "lower");
    auto& motion = *particles.add_motions();
    for (scene::Area* area : {group.mutable_where(), motion.mutable_where()}) {
      if (upper)
        area->set_y_min(kHeight);
      else
        area->set_y_max(0);
    }
    motion.mutable_velocity()->set_y(upper ? speed : 0);
  }
  auto& section = *particles.add_sections();
  section.set_name("middle");
  test::set(*section.mutable_from(), 0, kHeight / 2);
  test::set(*section.mutable_to(), kWidth, kHeight / 2);
  auto& history = *particles.add_histories();
  history.set_name("force");
  history.set_quantity(scene::THRUST);
  history.set_section("middle");
  return scene;
}

struct Outcome {
  double strength;       // the largest stress [Pa]
  double work, balance;  // [J]; what the time step made of nothing
};

Outcome pull(double size, double speed, double strain, std::uint64_t seed) {
  test::InProcessRun run(specimen(size, speed, seed));
  Outcome found{};
  while (static_cast<double>(run.next) * run.dt < strain * kHeight / std::abs(speed))
    found.strength = std::max(found.strength, std::abs(run.advance().histories(0)) / kWidth);
  found.work = run.predicted.energies().external_work();
  found.balance = run.shares()["time_step"];
  return found;
}

TEST(Laboratory, SpecimensTearAtTheTensileStrength) {
  for (const double size : {0.02, 0.01})
    for (const std::uint64_t seed : {1, 2, 3}) {
      const Outcome found = pull(size, 0.004, 1.5e-4, seed);
      EXPECT_NEAR(found.strength / kTensile, 1, 0.05) << size << ", seed " << seed;
      EXPECT_LT(std::abs(found.balance), 1e-3 * found.work);
    }
}

TEST(Laboratory, SpecimensAreCrushedAtTheCompressiveStrength) {
  for (const double size : {0.02, 0.01})
    for (const std::uint64_t seed : {1, 2, 3}) {
      const Outcome found = pull(size, -0.04, 1.7e-3, seed);
      EXPECT_NEAR(found.strength / kCompressive, 1, 0.05) << size << ", seed " << seed;
      // It bursts: steps are long beside the time in which facets lose their strength.
      EXPECT_LT(std::abs(found.balance), 1e-2 * found.work);
    }
}

// Facets that open under pressure release at once what they bore of the cells' swelling; the ledger has it.
TEST(Laboratory, CrushingUnderPressureKeepsEnergy) {
  constexpr double kSize = 0.01, kSpeed = 0.04, kPressure = 5e6;
  auto scene = specimen(kSize, -kSpeed, 1);
  for (const bool right : {false, true}) {
    auto& load = *scene.mutable_particles()->add_loads();
    load.mutable_where()->set_y_min(0);
    load.mutable_where()->set_y_max(kHeight);
    if (right)
      load.mutable_where()->set_x_min(kWidth - kSize);
    else
      load.mutable_where()->set_x_max(kSize);
    load.mutable_force()->set_x((right ? -1 : 1) * kPressure * kHeight);
  }
  test::InProcessRun run(scene, {}, 0.1);
  while (static_cast<double>(run.next) * run.dt < 2e-3 * kHeight / kSpeed) run.advance();
  const double work = run.predicted.energies().external_work();
  EXPECT_GT(run.shares()["fracture"], 0.1 * work);
  EXPECT_LT(std::abs(run.shares()["time_step"]), 1.5e-3 * work);
}

}  // namespace
}  // namespace adit::dem::laboratory_test

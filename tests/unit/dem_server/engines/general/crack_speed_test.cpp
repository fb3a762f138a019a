// Requirement: a crack runs through a stretched plate of cells at less than the speed of Rayleigh's waves,
// and the nearer to it the more energy the plate has stored (Freund 1990, Dynamic Fracture Mechanics).
//
// The plate is drawn slowly. The shorter its notch the more it bears, and stores, until a crack starts from
// there: sigma^2 H / 2E per area ahead of the crack, of which the crack takes G_f.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/dem_server/in_process_run.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::crack_speed_test {
namespace {

constexpr double kYoung = 30e9, kPoisson = 0.2, kDensity = 2400, kTensile = 2.5e6;  // [Pa], [kg/m^3]
constexpr double kSize = 0.01, kLength = 1, kHeight = 0.4;  // of the cells and the plate [m]
constexpr double kFrom = 0.26,
                 kTo = 0.56;  // where the crack is timed: behind its start, before the far side bends [m]
constexpr double kEnergy = 2 * kSize * kTensile * kTensile / kYoung;  // G_f [J/m^2]

// Of Rayleigh's waves in plane stress: the root of (2 - s)^2 = 4 sqrt(1 - s) sqrt(1 - s c_s^2 / c_p^2), s =
// (c / c_s)^2.
double rayleigh_speed() {
  const double shear = kYoung / (2 * (1 + kPoisson)) / kDensity, ratio = (1 - kPoisson) / 2;
  double low = 0.5, high = 1;
  while (high - low > 1e-9) {
    const double s = (low + high) / 2;
    ((2 - s) * (2 - s) > 4 * std::sqrt((1 - s) * (1 - s * ratio)) ? high : low) = s;
  }
  return std::sqrt(low * shear);
}

// Between grips that let go across and move apart until the plate would bear the tensile strength.
scene::Scene plate(double notch, std::uint64_t seed) {
  auto scene = test::empty_scene();
  auto& material = *scene.mutable_material();
  material.set_young_modulus(kYoung);
  material.set_poisson_ratio(kPoisson);
  material.set_density(kDensity);
  auto& fracture = *material.mutable_fracture();
  fracture.set_tensile_strength(kTensile);
  fracture.set_fracture_energy(kEnergy);
  fracture.set_compressive_strength(39e6);
  auto& particles = *scene.mutable_particles();
  auto& cells = *particles.mutable_cells();
  cells.set_x_min(0);
  cells.set_x_max(kLength);
  cells.set_y_min(-kHeight / 2 - kSize);
  cells.set_y_max(kHeight / 2 + kSize);
  cells.set_size(kSize);
  cells.set_seed(seed);
  const double slow = 8 * kHeight / std::sqrt(kYoung / kDensity);  // [s]
  for (const bool upper : {false, true}) {
    auto& grip = *particles.add_groups();
    grip.set_name(upper ? "upper" : "lower");
    auto& strong = *grip.mutable_bonds()->mutable_fracture();
    strong.set_tensile_strength(100e6);
    strong.set_fracture_energy(1e6);
    strong.set_compressive_strength(1e9);
    auto& motion = *particles.add_motions();
    for (scene::Area* area : {grip.mutable_where(), motion.mutable_where()}) {
      if (upper)
        area->set_y_min(kHeight / 2);
      else
        area->set_y_max(-kHeight / 2);
    }
    motion.mutable_velocity()->set_y((upper ? 0.5 : -0.5) * kTensile / kYoung * kHeight / slow);
    auto& table = *motion.mutable_time()->mutable_table();
    for (const double share : {0.0, 1.0}) {
      table.add_time(share * slow / 3);
      table.add_value(share);
    }
  }
  auto& cut = *particles.add_joints();
  test::set(*cut.mutable_from(), 0, 0);
  test::set(*cut.mutable_to(), notch, 0);
  cut.set_open(true);
  auto& section = *particles.add_sections();
  section.set_name("across");
  test::set(*section.mutable_from(), 0, kHeight / 4);
  test::set(*section.mutable_to(), kLength, kHeight / 4);
  auto& history = *particles.add_histories();
  history.set_name("force");
  history.set_quantity(scene::THRUST);
  history.set_section("across");
  return scene;
}

struct Crack {
  double stored;  // energy per area ahead of it as it begins to run, over G_f
  double speed;   // [m/s]
};

Crack crack_from(double notch, std::uint64_t seed) {
  test::InProcessRun run(plate(notch, seed), {}, 0.9);
  double stress = 0, start = 0;
  for (double tip = notch; tip < kTo;) {
    for (const auto& crack : run.advance().cracks()) tip = std::max(tip, crack.x());
    const double time = static_cast<double>(run.next) * run.dt;
    if (tip < kFrom) start = time;
    stress = std::max(stress, std::abs(run.predicted.histories(0)) / kLength);
  }
  const double passed = static_cast<double>(run.next) * run.dt - start;
  return {stress * stress * kHeight / (2 * kYoung * kEnergy), (kTo - kFrom) / passed};
}

TEST(CrackSpeed, ComesNearerToRayleighsTheMoreEnergyIsStored) {
  const double rayleigh = rayleigh_speed();
  Crack before{};
  for (const double notch : {0.12, 0.04, 0.015}) {
    Crack mean{};
    for (const std::uint64_t seed : {1, 2}) {
      const Crack crack = crack_from(notch, seed);
      EXPECT_LT(crack.speed, rayleigh) << notch << ", seed " << seed;
      mean.stored += crack.stored / 2;
      mean.speed += crack.speed / 2;
    }
    EXPECT_GT(mean.stored, 1.2 * before.stored) << notch;
    EXPECT_GT(mean.speed, before.speed) << notch;
    before = mean;
  }
  EXPECT_GT(before.speed, 0.8 * rayleigh);
}

}  // namespace
}  // namespace adit::dem::crack_speed_test

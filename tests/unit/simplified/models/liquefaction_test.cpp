// The whole tunnel in ground that liquefies: pressure by hand, springs, uplift, refusals.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "simplified/scene/ground.hpp"
#include "simplified/scene/liquefaction.hpp"
#include "simplified/zoom/write.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/simplified/scenes.hpp"

namespace adit::simplified::liquefaction_test {
namespace {

using testing::response_of;
using testing::tunnel;
using testing::with_model;

constexpr double kGravity = 9.80665;

// 10 m of loose sand below 8 m of clay, the water 6 m deep; the tunnel, 7 m high, has its axis at 8.5 m, so
// that 4 m of it, from 8 m to 12 m, lie in the sand.
scene::Scene loose(double resistance) {
  scene::Scene scene = tunnel();
  auto& simplified = *scene.mutable_simplified();
  simplified.mutable_tunnel()->add_axis()->set_chainage(0);
  simplified.mutable_tunnel()->mutable_axis(0)->set_depth(8.5);
  auto& ground = *simplified.mutable_ground();
  ground.set_water_depth(6);
  for (const double chainage : {0.0, 200.0}) {
    auto& profile = *ground.add_profiles();
    profile.set_chainage(chainage);
    for (const auto& [thickness, velocity, density] :
         {std::array{8.0, 150.0, 1700.0}, {10.0, 180.0, 1900.0}}) {
      auto& layer = *profile.add_layers();
      layer.set_thickness(thickness);
      layer.set_shear_velocity(velocity);
      layer.set_density(density);
    }
    profile.mutable_layers(1)->mutable_liquefaction()->set_cyclic_resistance(resistance);
  }
  simplified.mutable_excitation()->set_through_ground(true);
  return scene;
}

// Of a layer at a station, by its column's name in the histories.
std::vector<double> column_of(const Response& response, const std::string& name) {
  const auto& columns = response.histories.columns;
  const auto at = static_cast<std::size_t>(std::ranges::find(columns, name) - columns.begin());
  std::vector<double> values;
  for (const auto& row : response.histories.rows) values.push_back(row.at(at));
  return values;
}

// Requirement: the resistance counts against the effective pressure in the middle of what is wet of the
// layer.
TEST(WetSand, BearsTheEffectivePressureOfSaturatedGround) {
  scene::Ground ground = loose(0.12).simplified().ground();
  const auto sand = wet_sand(ground, ground.profiles(0), 1);
  EXPECT_DOUBLE_EQ(sand->middle(), 13);
  EXPECT_DOUBLE_EQ(sand->resistance, 0.12 * kGravity * (8 * 1700 + 5 * 1900 - 7 * 1000));
  EXPECT_EQ(sand->exponent, 0.34);
  ground.set_water_depth(14);
  const auto lower = wet_sand(ground, ground.profiles(0), 1);
  EXPECT_DOUBLE_EQ(lower->top, 14);
  EXPECT_DOUBLE_EQ(lower->resistance, 0.12 * kGravity * (8 * 1700 + 8 * 1900 - 2 * 1000));
  ground.set_water_depth(18);
  EXPECT_FALSE(wet_sand(ground, ground.profiles(0), 1));
  EXPECT_FALSE(wet_sand(ground, ground.profiles(0), 0));
}

// Requirement: towards a profile whose layer does not liquefy the resistance grows without bound.
TEST(WetSand, ResistanceGrowsTowardsGroundThatDoesNotLiquefy) {
  scene::Ground ground = loose(0.12).simplified().ground();
  ground.mutable_profiles(1)->mutable_layers(1)->clear_liquefaction();
  EXPECT_DOUBLE_EQ(profile_at(ground, 0).layers(1).liquefaction().cyclic_resistance(), 0.12);
  EXPECT_DOUBLE_EQ(profile_at(ground, 100).layers(1).liquefaction().cyclic_resistance(), 0.24);
  EXPECT_DOUBLE_EQ(profile_at(ground, 150).layers(1).liquefaction().cyclic_resistance(), 0.48);
  EXPECT_EQ(profile_at(ground, 150).layers(1).liquefaction().exponent(), 0.34);
  EXPECT_FALSE(profile_at(ground, 200).layers(1).has_liquefaction());
  EXPECT_FALSE(profile_at(ground, 300).layers(1).has_liquefaction());
}

// Requirement: a slow harmonic motion of the rock shears the ground by the mass above times its acceleration,
// and the pressure is that of its cycles.
TEST(Liquefaction, PressureIsThatOfTheCyclesOfStress) {
  constexpr double kFrequency = 0.25, kCycles = 8, kPeak = 1;
  const double stress = kPeak * (8 * 1700 + 5 * 1900);
  const double effective = kGravity * (8 * 1700 + 5 * 1900 - 7 * 1000);
  scene::Scene scene =
      with_model(loose(stress / effective * std::pow(2 * kCycles / 15, 0.34)), scene::Simplified::COLUMN);
  auto& excitation = *scene.mutable_simplified()->mutable_excitation();
  excitation.clear_incidence();
  excitation.set_axial(0.6);
  excitation.set_lateral(0.8);
  scene.mutable_time()->set_duration(kCycles / kFrequency);
  scene.mutable_time()->set_dt(0.01);
  const auto setup = set_up(scene);
  motion::Motion slow{.dt = 0.01, .acceleration = {}};
  for (int n = 0; n <= kCycles / kFrequency / 0.01; ++n)
    slow.acceleration.push_back(kPeak * std::sin(2 * std::numbers::pi * kFrequency * n * 0.01));
  const GroundField ground = shake(*setup.scene, slow, 0, 200, setup.clock.steps);
  ASSERT_EQ(ground.pressure.size(), 1U);
  EXPECT_EQ(ground.pressure[0].number, 1);
  // Half of the damage after half of the cycles; the amplification at a twelfth of the ground's frequency is
  // 1 %.
  const double expected = 2 / std::numbers::pi * std::asin(std::pow(0.5, 1 / 1.4));
  EXPECT_NEAR(ground.pressure[0].ratio.back(), expected, 0.05 * expected);
  EXPECT_EQ(ground.pressure[0].ratio.front(), 0);
}

// Requirement: the column tells the pressure of each layer that may liquefy, and it never falls.
TEST(Liquefaction, ColumnTellsThePressureOfItsLayers) {
  const Response response = response_of(with_model(loose(0.1), scene::Simplified::COLUMN));
  const std::vector<double> ratio = column_of(response, "middle_pressure_ratio_layer_2");
  EXPECT_TRUE(std::ranges::is_sorted(ratio));
  EXPECT_GT(ratio.back(), 0.1);
  EXPECT_GT(find(response, "pressure_ratio_layer_2")->greatest.back(), 0);
  EXPECT_EQ(find(response, "pressure_ratio_layer_1"), nullptr);
}

// Requirement: the tunnel feels the mean over its height, 4 of its 7 m, and rises by what liquefied ground
// weighs more than it does, on springs that have weakened.
TEST(Liquefaction, TheTunnelFeelsItsHeightAndRises) {
  scene::Scene scene = loose(0.01);  // liquefies at once
  scene.mutable_time()->set_duration(10);
  scene.mutable_simplified()->mutable_soil_springs()->set_dashpot_time(0.05);
  const Response response = response_of(scene);
  EXPECT_NEAR(column_of(response, "middle_pressure_ratio").back(), 4.0 / 7, 1e-9);
  EXPECT_NEAR(find(response, "pressure_ratio")->greatest[50], 4.0 / 7, 1e-9);
  const double density = (3 * 1700 + 4 * 1900) / 7.0;
  const double load = 4.0 / 7 * kGravity * (density * 7 * 7 - 5e4);
  const double expected = load / (5e7 * (1 - 4.0 / 7 * (1 - 0.1)));
  EXPECT_NEAR(column_of(response, "middle_uz_m").back(), expected, 1e-3 * expected);
  EXPECT_GE(find(response, "uplift")->greatest[50], expected * (1 - 1e-3));
  const double energy_error =
      std::ranges::find(response.figures, "energy_error", &std::pair<std::string, double>::first)->second;
  EXPECT_LT(energy_error, 1e-9);
}

// Requirement: a tunnel as heavy as the ground that it replaces neither rises nor sinks: factor of flotation
// m/(rho A) = 1.
TEST(Liquefaction, AFlotationFactorOfOneIsNoUplift) {
  const scene::Scene scene = loose(0.1);
  scene::Section section = scene.simplified().tunnel().sections(0);
  section.set_mass((3 * 1700 + 4 * 1900) / 7.0 * 7 * 7);
  EXPECT_NEAR(uplift(scene.simplified(), 50, section), 0, 1e-6);
  section.set_mass(0.5 * section.mass());
  EXPECT_NEAR(uplift(scene.simplified(), 50, section), kGravity * section.mass(), 1e-6);
}

void expect_refusal(const scene::Scene& scene, const std::string& path, const std::string& text) {
  adit::test::expect_refusal([&] { set_up(scene); }, path, text);
}

TEST(Liquefaction, RefusesWhatItCannotCompute) {
  scene::Scene scene = loose(0.1);
  scene.mutable_simplified()->mutable_ground()->clear_water_depth();
  expect_refusal(scene, "simplified.ground.water_depth", "needs the water table");
  scene = loose(0.1);
  scene.mutable_simplified()->mutable_excitation()->clear_through_ground();
  expect_refusal(scene, "simplified.excitation.through_ground", "shear stress in the soil columns");
  scene = loose(0.1);
  auto& profile = *scene.mutable_simplified()->mutable_ground()->mutable_profiles(1);
  for (auto& layer : *profile.mutable_layers()) layer.set_density(600);
  scene.mutable_simplified()->mutable_ground()->set_water_depth(0);
  expect_refusal(scene, "simplified.ground.profiles[1].layers[1].density", "saturated ground");
  expect_refusal(with_model(loose(0.1), scene::Simplified::CHAIN), "simplified.ground",
                 "needs the model beam");
  const scene::Scene zoomed = loose(0.1);
  adit::test::expect_refusal([&] { check_zoom(set_up(zoomed), "worst-opening"); }, "--zoom",
                             "stay as they are");
}

}  // namespace
}  // namespace adit::simplified::liquefaction_test

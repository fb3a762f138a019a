// Between soil columns the ground motion is smooth, so that a tunnel has the curvature of the wave
// everywhere.
#include "simplified/scene/along_chainage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simplified/models/solve.hpp"
#include "tests/unit/simplified/scenes.hpp"

namespace adit::simplified::along_chainage_test {
namespace {

constexpr double kLength = 1200, kSpacing = 60, kWave = 2 * std::numbers::pi / 600;  // [m], [m], [rad/m]
constexpr double kPhase = kWave * kSpacing;
// A cubic spline's largest error in curvature (Hall and Meyer 1976, second derivative), part of the wave's.
constexpr double kCurvatureError = kPhase * kPhase / 12;

std::vector<double> every(double spacing) {
  std::vector<double> places;
  for (int i = 0; i * spacing <= kLength; ++i) places.push_back(i * spacing);
  return places;
}

std::vector<double> wave(const std::vector<double>& places) {
  std::vector<double> values;
  for (const double x : places) values.push_back(std::sin(kWave * x));
  return values;
}

// Requirement: displacement and curvature of a wave between the places are within the spline's error bounds.
TEST(AlongChainage, KeepsAWavesDisplacementAndCurvature) {
  const std::vector<double> places = every(kSpacing), between = every(1);
  std::vector<double> values(between.size());
  AlongChainage(places, between).interpolate(wave(places).data(), values.data());
  for (std::size_t i = 1; i + 1 < between.size(); ++i) {
    const double exact = std::sin(kWave * between[i]);
    EXPECT_NEAR(values[i], exact, 5 * std::pow(kPhase, 4) / 384);
    // Second differences of a cubic are exact, and at the places a mean of the curvatures on either side.
    const double curvature = values[i - 1] - 2 * values[i] + values[i + 1];
    EXPECT_NEAR(curvature, -kWave * kWave * exact, kWave * kWave * kCurvatureError);
  }
}

TEST(AlongChainage, KeepsStraightLinesAndGoesOnBeyondTheEnds) {
  std::vector<double> values(4);
  AlongChainage({0, 10, 40, 60}, {-5, 3, 50, 70})
      .interpolate(std::vector{1.0, 3.0, 9.0, 13.0}.data(), values.data());
  EXPECT_DOUBLE_EQ(values[0], 1);
  EXPECT_NEAR(values[1], 1.6, 1e-14);
  EXPECT_NEAR(values[2], 11, 1e-14);
  EXPECT_DOUBLE_EQ(values[3], 13);
}

// Requirement: between places at any distances the curve is the natural cubic spline: value, slope and
// curvature go on at each place, and both ends are straight. Four values at equal distances tell all of a
// cubic.
TEST(AlongChainage, IsTheNaturalSplineOfUnequalGaps) {
  const std::vector<double> places = {0, 10, 40, 60, 63}, given = {1, -2, 5, 0, 2};
  std::vector<double> chainages;
  for (std::size_t k = 0; k + 1 < places.size(); ++k)
    for (int i = 0; i < 4; ++i) chainages.push_back(places[k] + (places[k + 1] - places[k]) * i / 3);
  std::vector<double> f(chainages.size());
  AlongChainage(places, chainages).interpolate(given.data(), f.data());
  double slope = 0, curvature = 0;
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    const double* v = f.data() + 4 * k;
    const double h = (places[k + 1] - places[k]) / 3;
    EXPECT_NEAR(v[0], given[k], 1e-12);
    EXPECT_NEAR(v[3], given[k + 1], 1e-12);
    const double begins = (-11 * v[0] + 18 * v[1] - 9 * v[2] + 2 * v[3]) / (6 * h);
    EXPECT_NEAR(k > 0 ? begins - slope : 0, 0, 1e-10) << k;
    EXPECT_NEAR((2 * v[0] - 5 * v[1] + 4 * v[2] - v[3]) / (h * h), curvature, 1e-10) << k;
    slope = (11 * v[3] - 18 * v[2] + 9 * v[1] - 2 * v[0]) / (6 * h);
    curvature = (2 * v[3] - 5 * v[2] + 4 * v[1] - v[0]) / (h * h);
  }
  EXPECT_NEAR(curvature, 0, 1e-10);
}

// The largest error of the moment, amplitude * sin(q x), away from the free ends, of a tunnel without mass
// whose ground takes the form of the wave in one step.
double moment_error(const scene::Simplified& scene, double spacing, double amplitude) {
  const Line line = divide(scene.tunnel());
  GroundField ground;
  ground.chainage = every(spacing);
  Shaking& lateral = ground.shaking[kLateral];
  lateral.places = ground.chainage.size();
  lateral.displacement.resize(lateral.places);
  for (const double u : wave(ground.chainage)) lateral.displacement.push_back(u);
  lateral.velocity.resize(2 * lateral.places);
  const Response response = solve_beam(scene, line, ground, {.dt = 1, .steps = 1, .stride = 1});
  const Envelope& moment = *find(response, "moment_lateral");
  double error = 0;
  for (std::size_t i = 0; i < response.chainage.size(); ++i) {
    const double x = response.chainage[i];
    if (std::abs(x - kLength / 2) > kLength / 4) continue;
    error = std::max(error, std::abs(moment.greatest[i] + moment.least[i] + amplitude * std::sin(kWave * x)));
  }
  return error;
}

// Requirement: with columns three bending lengths apart the moment is that of the closed form (physics.md 5),
// EI q^2/(1 + EI q^4/K), within the spline's error in curvature; so is that of columns close by.
TEST(AlongChainage, TunnelBendsBetweenColumnsThatStandFarApart) {
  constexpr double kElement = 5;
  scene::Scene scene = testing::tunnel();
  scene::Simplified& model = *scene.mutable_simplified();
  scene::Tunnel& tunnel = *model.mutable_tunnel();
  tunnel.clear_joints();
  tunnel.set_inertia(false);
  tunnel.mutable_sections(0)->set_to(kLength / 2);
  tunnel.mutable_sections(1)->set_from(kLength / 2);
  tunnel.mutable_sections(1)->set_to(kLength);
  for (auto& section : *tunnel.mutable_sections()) section.set_element_length(kElement);
  model.mutable_soil_springs()->clear_dashpot_time();
  model.clear_stations();
  const auto& section = tunnel.sections(0);
  const double EI = section.young_modulus() * section.lateral_inertia(), K = model.soil_springs().lateral();
  ASSERT_GT(kSpacing, 3 * std::pow(4 * EI / K, 0.25));
  const double exact = EI * kWave * kWave / (1 + EI * std::pow(kWave, 4) / K);
  const double of_element = std::pow(kWave * kElement, 2) / 24;  // its moment is the mean over its length
  EXPECT_LT(moment_error(model, kSpacing, exact), (kCurvatureError + of_element) * exact);
  EXPECT_LT(moment_error(model, kElement, exact), (std::pow(kWave * kElement, 2) / 12 + of_element) * exact);
}

}  // namespace
}  // namespace adit::simplified::along_chainage_test

// Requirement: a cantilever of five rows of particles that bends as the solid agrees with Timoshenko's beam
// within 1 % in deflection and first frequency, alone and coupled to a grid.
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <google/protobuf/text_format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "coupler/stepping/stepper.hpp"
#include "tests/support/local_participants.hpp"

namespace adit::thin_strip_test {
namespace {

constexpr int kRows = 5, kDiscs = 87;
constexpr double kLength = 10, kYoung = 25e9, kPoisson = 0.2, kDensity = 2500, kForce = 1e3;
constexpr double kRadius = kLength / (2 * kDiscs), kHeight = kRows * std::numbers::sqrt3 * kRadius;
// The last column of centres is fixed.
constexpr double kFree = kLength - kRadius;

constexpr double kBending = kYoung * kHeight * kHeight * kHeight / 12;
constexpr double kShear = 5.0 / 6 * kYoung / (2 * (1 + kPoisson)) * kHeight;

double deflection_in_theory(double length) {
  return kForce * (length * length * length / (3 * kBending) + length / kShear);
}

// Bending and shear combined by Dunkerley's formula.
double period_in_theory() {
  const double line_mass = kDensity * kHeight;
  const double bending = std::pow(1.8751041, 4) * kBending / (line_mass * std::pow(kFree, 4));
  const double shear = std::pow(std::numbers::pi / (2 * kFree), 2) * kShear / line_mass;
  return 2 * std::numbers::pi * std::sqrt(1 / bending + 1 / shear);
}

// Particles fixed at the right end; more of them, and of the scene.
scene::Scene cantilever(const std::string& particles, const std::string& rest) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(
      fmt::format("plane: PLANE_STRESS material {{ young_modulus: {} poisson_ratio: {} density: {} }} "
                  "time {{ duration: {} dt_factor: 0.9 }} "
                  "particles {{ packing {{ x_min: 0 x_max: {} y_min: 0 y_max: {:.17g} radius: {:.17g} "
                  "bends_as_solid: true }} "
                  "motions {{ where {{ x_min: {} }} velocity {{ x: 0 y: 0 }} spin: 0 }} {} }} {}",
                  kYoung, kPoisson, kDensity, 3.4 * period_in_theory(), kLength, kHeight, kRadius,
                  kLength - 1.5 * kRadius, particles, rest),
      &scene))
      << particles << rest;
  return scene;
}

scene::Scene of_particles() {
  return cantilever(fmt::format("loads {{ where {{ x_max: {} }} force {{ y: {} }} }} "
                                "histories {{ name: 'tip' quantity: DISPLACEMENT_Y at {{ x: {} y: {} }} }}",
                                1.5 * kRadius, kForce, kRadius, kHeight / 2),
                    "");
}

scene::Scene coupled() {
  return cantilever(
      "", fmt::format(
              "interface {{ overlap {{ particles_begin {{ x: 4 y: 0 }} continuum_ends {{ x: 6 y: 0 }} }} }} "
              "continuum {{ block {{ x_min: 0 x_max: {} y_min: 0 y_max: {:.17g} zones_x: 40 zones_y: 4 }} "
              "edge_loads {{ where {{ x_max: 0 }} force {{ y: {} }} }} "
              "histories {{ name: 'tip' quantity: DISPLACEMENT_Y at {{ x: 0 y: {} }} }} }}",
              kLength, kHeight, kForce, kHeight / 2));
}

// The tip swings about the deflection under the load, put on at once. Over three whole swings from one upward
// passage of the expected deflection to another, other modes add less than 0.1 % to either.
struct Swing {
  double deflection, period;
};
Swing swing(const scene::Scene& scene, double expected) {
  coupler::Model model = test::local_model(scene);
  coupler::Stepper stepper(model);
  std::vector<double> tip, sums;  // of every step
  std::vector<double> passages;   // [steps]
  double sum = 0;
  for (std::uint64_t n = 0; n <= model.steps; ++n) {
    stepper.step(n, {.energies = false, .histories = true});
    for (const coupler::Participant& participant : model.participants)
      if (participant.prediction().histories_size() == 1)
        tip.push_back(participant.prediction().histories(0));
    sums.push_back(sum += tip.back());
    if (n > 0 && tip[n - 1] < expected && tip[n] >= expected)
      passages.push_back(static_cast<double>(n) - (tip[n] - expected) / (tip[n] - tip[n - 1]));
  }
  EXPECT_GE(passages.size(), 4u);
  if (passages.size() < 4) return {0, 0};
  const auto first = static_cast<std::size_t>(passages[0]), last = static_cast<std::size_t>(passages[3]);
  return {(sums[last] - sums[first]) / static_cast<double>(last - first),
          (passages[3] - passages[0]) / 3 * model.dt};
}

void expect_as_timoshenko(const scene::Scene& scene, double length) {
  const double expected = deflection_in_theory(length);
  const Swing found = swing(scene, expected);
  EXPECT_NEAR(found.deflection / expected, 1, 0.01);
  EXPECT_NEAR(found.period / period_in_theory(), 1, 0.01);
}

TEST(ThinStrip, OfParticlesSwingsAsTimoshenkosBeam) {
  expect_as_timoshenko(of_particles(), kLength - 2 * kRadius);
}

TEST(ThinStrip, CoupledSwingsAsTimoshenkosBeam) {
  expect_as_timoshenko(coupled(), kFree);
}

}  // namespace
}  // namespace adit::thin_strip_test

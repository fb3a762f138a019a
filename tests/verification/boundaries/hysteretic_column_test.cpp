// Requirement: a column of hysteretic ground, shaken far into its nonlinear range, moves as an independent
// integration of the same law does: a chain of masses and springs whose backbone is the hyperbola itself and
// whose branches come from Masing's rules, with memory of every reversal.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/unit/fdm_server/boundaries/boundary_scenes.hpp"

namespace adit::fdm::test::hysteretic_column_test {
namespace {

constexpr double kHeight = 20, kReference = 1e-3, kModulus = kGroundDensity * kShearVelocity * kShearVelocity;
constexpr double kDuration = 1.5, kFrequency = 2, kAmplitude = 0.4;  // [s], [Hz], [m/s]

// Stress of one spring by the extended rules of Masing: from the last reversal the branch is the backbone
// doubled; where it meets the branch that the loop left, it goes on with that one.
class Masing {
 public:
  double stress(double strain) {
    const int heading = strain > strain_ ? 1 : strain < strain_ ? -1 : heading_;
    if (heading_ != 0 && heading != heading_) turns_.push_back({strain_, stress_});
    heading_ = heading;
    // a branch ends at the reversal before its own: a closed loop is forgotten, and so is what led to it
    while (turns_.size() >= 2 && (strain - turns_[turns_.size() - 2].strain) * heading > 0)
      turns_.resize(turns_.size() - 2);
    // the first branch of all ends where it leaves the range of the virgin curve
    if (turns_.size() == 1 && std::abs(strain) > std::abs(turns_[0].strain) && strain * turns_[0].strain < 0)
      turns_.clear();
    strain_ = strain;
    stress_ = turns_.empty() ? backbone(strain)
                             : turns_.back().stress + 2 * backbone((strain - turns_.back().strain) / 2);
    return stress_;
  }

 private:
  struct Turn {
    double strain, stress;
  };
  static double backbone(double strain) { return kModulus * strain / (1 + std::abs(strain) / kReference); }

  double strain_ = 0, stress_ = 0;
  int heading_ = 0;
  std::vector<Turn> turns_;
};

double base_velocity(double t) {
  return kAmplitude * std::sin(2 * std::numbers::pi * kFrequency * t);
}

// Velocity of the chain's head at the times (n - 1/2) dt, for the same steps.
std::vector<double> chain(std::size_t springs, double dt, std::size_t steps) {
  const double h = kHeight / static_cast<double>(springs);
  std::vector<Masing> law(springs);
  std::vector<double> u(springs + 1, 0.0), v(springs + 1, 0.0), stress(springs + 1, 0.0), head;
  for (std::size_t n = 0; n <= steps; ++n) {
    head.push_back(v[springs]);
    for (std::size_t i = 0; i <= springs; ++i) u[i] += dt * v[i];
    for (std::size_t i = 0; i < springs; ++i) stress[i] = law[i].stress((u[i + 1] - u[i]) / h);
    v[0] = base_velocity((static_cast<double>(n) + 0.5) * dt);
    for (std::size_t i = 1; i <= springs; ++i) {
      const double mass = kGroundDensity * h * (i == springs ? 0.5 : 1);
      v[i] += dt * ((i == springs ? 0 : stress[i]) - stress[i - 1]) / mass;
    }
  }
  return head;
}

TEST(HystereticColumn, MovesAsAnIndependentIntegrationOfItsLaw) {
  constexpr int kZones = 40;
  GroundRun run(
      fmt::format("block {{ x_min: 0 x_max: 0.5 y_min: 0 y_max: {} zones_x: 1 zones_y: {} }} material {{ "
                  "young_modulus: {} poisson_ratio: 0.25 density: {} hysteretic {{ hyperbola {{ "
                  "reference_strain: {} }} }} }} motions {{ where {{ y_min: 0.01 }} velocity {{ y: 0 }} }} "
                  "base {{ velocity {{ amplitude: {} time {{ sine {{ frequency: {} }} }} }} }} histories {{ "
                  "name: 's' quantity: VELOCITY_X at {{ x: 0 y: {} }} }}",
                  kHeight, kZones, 2.5 * kModulus, kGroundDensity, kReference, kAmplitude, kFrequency,
                  kHeight),
      kDuration);
  const auto expected = chain(kZones, run.dt, run.steps());
  double largest = 0, difference = 0, square = 0, squares = 0;
  for (std::uint64_t n = 0; n <= run.steps(); ++n) {
    const double v = run.advance().histories(0);
    largest = std::max(largest, std::abs(expected[n]));
    difference = std::max(difference, std::abs(v - expected[n]));
    square += (v - expected[n]) * (v - expected[n]);
    squares += expected[n] * expected[n];
  }
  EXPECT_GT(largest, 0.1 * kAmplitude);
  RecordProperty("largest_difference", std::to_string(difference / largest));
  EXPECT_LE(std::sqrt(square / squares), 0.01);
  EXPECT_LE(difference, 0.02 * largest);
}

}  // namespace
}  // namespace adit::fdm::test::hysteretic_column_test

// A short immersed tunnel in an earthquake: gaskets open, keys strike, soil slips. Energy is accounted for.
#include <gtest/gtest.h>

#include "tests/unit/simplified/beam/tunnels.hpp"

namespace adit::simplified::beam::earthquake_test {
namespace {

constexpr double kSegment = 90, kElements = 8, kLength = kSegment * kElements;

Tunnel jointed_tunnel() {
  Tunnel tunnel = immersed_tube(0, kLength, 22.5, 0);
  tunnel.sections[0].load = {0, 0, -1e5};
  tunnel.start = Portal::kFixed;
  const std::vector<CurvePoint> rubber = {{0, 0}, {0.05, 0.4e6}, {0.10, 1.4e6}, {0.15, 4e6}};
  for (int i = 1; i < kElements; ++i) {
    Joint joint;
    joint.chainage = i * kSegment;
    joint.hydrostatic_force = 40e6;
    joint.gaskets = rectangular_gasket(kWidth, 11.4, 3, rubber);
    joint.springs = {{-10, 0, cable(2e8, 0.03)}, {10, 0, cable(2e8, 0.03)}};
    joint.lateral = joint.vertical = key(2e9, 0.005);
    tunnel.joints.push_back(joint);
  }
  for (auto& station : tunnel.soil)
    station.springs = {{{1e8, 4e5, 0.05, 1e6}, {1.6e8, 2e6, 0.1, 1e6}, {2e8, 1e6, 0.2, 1e6}}};
  return tunnel;
}

// A burst of 1 Hz, 0.1 g, in all directions, running along the axis; infinite speed: everywhere at once.
GroundMotion burst(double speed) {
  return [speed](double t, std::span<const double> chainages, GroundState& state) {
    for (int d = 0; d < 3; ++d)
      for (std::size_t i = 0; i < chainages.size(); ++i) {
        const double s = t - chainages[i] / speed, peak = d == kAxial ? 0.08 : 0.04;
        const double omega = 2 * kPi * 1.0,
                     envelope = s > 0 && s < 5 ? std::pow(std::sin(kPi * s / 5), 2) : 0;
        const double slope = s > 0 && s < 5 ? kPi / 5 * std::sin(2 * kPi * s / 5) : 0;
        state.displacement[d][i] = peak * envelope * std::sin(omega * s);
        state.velocity[d][i] = peak * (slope * std::sin(omega * s) + envelope * omega * std::cos(omega * s));
      }
  };
}

Results shaken(const Scheme& scheme, double dt, double speed = 400) {
  RunOptions options;
  options.dt = dt;
  options.steps = std::lround(8 / dt);
  options.scheme = scheme;
  return run(jointed_tunnel(), burst(speed), options);
}

bool any_gasket_opened(const Results& results) {
  for (const auto& joint : results.joints)
    if (std::isfinite(joint.contact_lost_time)) return true;
  return false;
}

TEST(Earthquake, EnergyIsConservedToOneMillionthInANonlinearRun) {
  for (const double dt : {0.01, 0.005}) {
    const Results results = shaken(energy_conserving(), dt);
    EXPECT_TRUE(any_gasket_opened(results));
    EXPECT_GT(results.energy.slip, 0.01 * results.energy.input);
    EXPECT_GT(results.energy.joints + results.energy.dashpots, 0);
    EXPECT_LE(results.energy_error, 1e-6);
  }
}

// Newmark's rule does not conserve energy where springs change their slope within a step: its error falls
// with the step.
TEST(Earthquake, EnergyErrorOfNewmarkFallsWithTheStep) {
  const double coarse = shaken(newmark(), 0.004).energy_error, fine = shaken(newmark(), 0.001).energy_error;
  EXPECT_LT(fine, coarse / 8);
  EXPECT_LT(fine, 1e-4);
}

TEST(Earthquake, SchemesAgreeAsTheStepShrinks) {
  const Results reference = shaken(energy_conserving(), 0.0005);
  for (const Scheme& scheme : {newmark(), hht(0.05)}) {
    const Results results = shaken(scheme, 0.0005);
    for (std::size_t j = 0; j < reference.joints.size(); ++j)
      EXPECT_NEAR(results.joints[j].largest_opening / reference.joints[j].largest_opening, 1, 0.01);
  }
}

TEST(Earthquake, ATravellingWaveOpensJointsMoreThanAUniformMotion) {
  const auto largest = [](const Results& results) {
    double opening = 0;
    for (const auto& joint : results.joints) opening = std::max(opening, joint.largest_opening);
    return opening;
  };
  Tunnel tunnel = jointed_tunnel();
  tunnel.start = Portal::kFree;
  RunOptions options;
  options.dt = 0.005;
  options.steps = 1600;
  const double uniform = largest(run(tunnel, burst(std::numeric_limits<double>::infinity()), options));
  const double at_1000 = largest(run(tunnel, burst(1000), options)),
               at_400 = largest(run(tunnel, burst(400), options));
  EXPECT_GT(at_1000, 3 * uniform);
  EXPECT_GT(at_400, at_1000);
}

TEST(Earthquake, ResultsAreTheSameToTheBitWhenRepeated) {
  const Results first = shaken(energy_conserving(), 0.01), second = shaken(energy_conserving(), 0.01);
  EXPECT_EQ(first.axial_force.maximum, second.axial_force.maximum);
  EXPECT_EQ(first.energy.input, second.energy.input);
}

}  // namespace
}  // namespace adit::simplified::beam::earthquake_test

// The integration in time against the closed form of a tube that moves as one body on springs and dashpots:
// u″ + 2ξω u′ + ω² u = ω² g + 2ξω g′ with g = A (1 − cos Ωt), from rest.
#include <gtest/gtest.h>

#include <complex>

#include "tests/unit/simplified/beam/tunnels.hpp"

namespace adit::simplified::beam::time_test {
namespace {

constexpr double kSoil = 1.661e8, kMass = 4.3e5, kAmplitude = 0.1, kDrive = 2 * kPi * 1.3, kDuration = 2.0;
constexpr double kDamping = 0.1;

double exact(double t) {
  const double omega = std::sqrt(kSoil / kMass), damped = omega * std::sqrt(1 - kDamping * kDamping);
  const std::complex<double> i(0, 1), lossy = omega * omega + 2. * i * kDamping * omega * kDrive;
  const std::complex<double> response = lossy / (lossy - kDrive * kDrive);
  const double c1 = kAmplitude * (response.real() - 1);
  const double c2 = (kAmplitude * (i * kDrive * response).real() + kDamping * omega * c1) / damped;
  return kAmplitude * (1 - (response * std::exp(i * kDrive * t)).real()) +
         std::exp(-kDamping * omega * t) * (c1 * std::cos(damped * t) + c2 * std::sin(damped * t));
}

Results shaken(Direction direction, const Scheme& scheme, double dt, Portal portal, bool inertia) {
  Tunnel tunnel = immersed_tube(0, 200, 20, kSoil);
  tunnel.start = tunnel.end = portal;
  tunnel.inertia = inertia;
  for (auto& station : tunnel.soil)
    for (auto& spring : station.springs) spring.dashpot = 2 * kDamping * std::sqrt(kSoil * kMass);
  RunOptions options;
  options.dt = dt;
  options.steps = std::lround(kDuration / dt);
  options.scheme = scheme;
  options.stations = {100};
  return run(tunnel,
             moving(
                 direction, [](double t, double) { return kAmplitude * (1 - std::cos(kDrive * t)); },
                 [](double t, double) { return kAmplitude * kDrive * std::sin(kDrive * t); }),
             options);
}

double error(Direction direction, const Scheme& scheme, double dt) {
  double largest = 0;
  for (const Record& record : shaken(direction, scheme, dt, Portal::kFree, true).histories)
    largest = std::max(largest, std::abs(record.displacement[direction][0] - exact(record.time)));
  return largest;
}

TEST(Integration, NewmarkHhtAndTheEnergyConservingSchemeAreOfOrderTwo) {
  for (const Scheme& scheme : {newmark(), hht(0.1), hht(1. / 3), energy_conserving()})
    for (const Direction direction : {kAxial, kLateral, kVertical}) {
      double previous = error(direction, scheme, 0.005);
      for (const double dt : {0.0025, 0.00125}) {
        const double now = error(direction, scheme, dt);
        EXPECT_NEAR(std::log2(previous / now), 2, 0.1) << "alpha_f " << scheme.alpha_f << " dt " << dt;
        previous = now;
      }
      EXPECT_LT(previous, 2e-3 * kAmplitude);
    }
}

// Fixed portals bind the ends to the ground: in a uniform motion without inertia the whole tube goes with it.
TEST(Integration, WithoutInertiaAUniformMotionCarriesTheTubeAlong) {
  const Results results = shaken(kLateral, newmark(), 0.005, Portal::kFixed, false);
  for (const Record& record : results.histories)
    EXPECT_NEAR(record.displacement[kLateral][0], kAmplitude * (1 - std::cos(kDrive * record.time)),
                1e-3 * kAmplitude);
  EXPECT_EQ(results.energy.kinetic, 0);
}

// Inertia makes the tube lag behind the ground.
TEST(Integration, InertiaIsSwitchable) {
  const double with = shaken(kLateral, newmark(), 0.005, Portal::kFixed, true).moment_lateral.maximum[0];
  const double without = shaken(kLateral, newmark(), 0.005, Portal::kFixed, false).moment_lateral.maximum[0];
  EXPECT_GT(with, 100 * std::abs(without));
}

// HHT damps what is short against the step, Newmark's average acceleration does not.
TEST(Integration, HhtDissipatesAndNewmarkDoesNot) {
  const auto lost = [](const Scheme& scheme) {
    Tunnel tunnel = immersed_tube(0, 200, 20, kSoil);
    RunOptions options;
    options.dt = 0.05;
    options.steps = 200;
    options.scheme = scheme;
    return run(tunnel,
               moving(
                   kAxial, [](double t, double) { return t > 0 ? 0.1 : 0; },
                   [](double, double) { return 0; }),
               options)
        .energy_error;
  };
  EXPECT_LT(lost(newmark()), 1e-10);
  EXPECT_GT(lost(hht(0.2)), 1e-2);
}

}  // namespace
}  // namespace adit::simplified::beam::time_test

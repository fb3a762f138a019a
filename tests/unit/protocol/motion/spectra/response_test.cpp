// Requirements on the response of oscillators.
#include "protocol/motion/spectra/response.hpp"

#include <gmock/gmock.h>

#include "protocol/motion/measures.hpp"
#include "protocol/motion/synthesis/pulses.hpp"
#include "tests/unit/protocol/motion/support.hpp"

namespace adit::motion::test::response_test {
namespace {

using testing::HasSubstr;

constexpr double kPeriod = 0.7;
constexpr double kDamping = 0.05;
constexpr double kW = 2 * kPi / kPeriod;

// Under a constant and under a steady rise of acceleration the response is the closed form, to rounding,
// although the step is a fifth of the period.
TEST(Oscillator, IsExactForStraightLines) {
  const double step = 0.14, damped = kW * std::sqrt(1 - kDamping * kDamping);
  const auto unit_step = [&](double t) {
    return -(1 - std::exp(-kDamping * kW * t) *
                     (std::cos(damped * t) + kDamping * kW / damped * std::sin(damped * t))) /
           (kW * kW);
  };
  // The response to the acceleration t is the integral of that to 1.
  const auto unit_ramp = [&](double t) {
    const double e = std::exp(-kDamping * kW * t), c = std::cos(damped * t), s = std::sin(damped * t);
    const double lag = 2 * kDamping / kW;
    return -(t - lag + e * (lag * c + (2 * kDamping * kDamping - 1) / damped * s)) / (kW * kW);
  };
  const auto constant =
      oscillator_response(sampled(step, 100, [](double) { return 1.0; }), kPeriod, kDamping);
  const auto ramp = oscillator_response(sampled(step, 100, [](double t) { return t; }), kPeriod, kDamping);
  for (std::size_t i = 0; i < 100; ++i) {
    const double t = step * static_cast<double>(i);
    EXPECT_NEAR(constant.displacement[i], unit_step(t), 1e-14);
    EXPECT_NEAR(ramp.displacement[i], unit_ramp(t), 1e-14);
    EXPECT_NEAR(ramp.velocity[i], unit_step(t), 1e-13);
  }
}

// At resonance the steady state is 1/(2 damping) times the static displacement.
TEST(Oscillator, ReachesTheResonantAmplitude) {
  const Motion motion = sine(1, 1 / kPeriod, 60, {.dt = 0.002, .duration = 60});
  const auto response = oscillator_response(motion, kPeriod, kDamping);
  double largest = 0;
  for (std::size_t i = 29000; i < 30000; ++i) largest = std::max(largest, std::abs(response.displacement[i]));
  EXPECT_NEAR(largest * kW * kW * 2 * kDamping, 1, 1e-3);
}

// The free swing after the motion keeps its energy where there is no damping.
TEST(Oscillator, KeepsItsEnergyWithoutDamping) {
  Motion motion{0.01, std::vector<double>(10000)};
  motion.acceleration[1] = 1;
  const auto response = oscillator_response(motion, kPeriod, 0);
  const auto energy = [&](std::size_t i) {
    return std::pow(response.velocity[i], 2) + std::pow(kW * response.displacement[i], 2);
  };
  EXPECT_NEAR(energy(9999) / energy(2), 1, 1e-10);
}

// The rigid and the very stiff oscillator follow the ground; the very soft one stays where it is.
TEST(Spectrum, HasTheLimitsOfStiffAndSoft) {
  const Motion motion = ricker(2, 1, 2, {.dt = 0.01, .duration = 4});
  const auto spectrum = response_spectrum(motion, std::vector{0.0, 0.01, 500.0}, kDamping);
  EXPECT_EQ(spectrum.pseudo_acceleration[0], 2);
  EXPECT_EQ(spectrum.absolute_acceleration[0], 2);
  EXPECT_EQ(spectrum.displacement[0], 0);
  EXPECT_NEAR(spectrum.pseudo_acceleration[1], 2, 2e-2);
  EXPECT_NEAR(spectrum.displacement[2], peaks(motion).displacement, 0.03 * peaks(motion).displacement);
}

// At resonance the largest velocity and displacement are those of the steady state, A / (2 damping w) and
// that by w.
TEST(Spectrum, VelocityAtResonance) {
  const Motion motion = sine(1, 1 / kPeriod, 60, {.dt = 0.002, .duration = 60});
  const auto spectrum = response_spectrum(motion, std::vector{kPeriod}, kDamping);
  EXPECT_NEAR(spectrum.velocity[0] * 2 * kDamping * kW, 1, 1e-3);
  EXPECT_NEAR(spectrum.displacement[0] * 2 * kDamping * kW * kW, 1, 1e-3);
}

// Peaks between the times of the motion are seen: the undamped oscillator under a sudden constant swings to
// twice the static displacement, although the step is nearly half its period.
TEST(Spectrum, SeesPeaksBetweenTheSteps) {
  const auto spectrum =
      response_spectrum(sampled(0.31, 4, [](double) { return 1.0; }), std::vector{0.7, 0.05}, 0);
  for (const double pseudo : spectrum.pseudo_acceleration) {
    EXPECT_LE(pseudo, 2 + 1e-12);
    EXPECT_GE(pseudo, 2 * (1 - 0.003));
  }
}

// Under a steady sine the absolute acceleration is passed on by the closed form, whose damper adds to the
// spring where damping is strong: sqrt(1 + (2 d r)^2) / sqrt((1 - r^2)^2 + (2 d r)^2), r the ratio of the
// frequencies.
TEST(Spectrum, AbsoluteAccelerationHoldsTheDampersForce) {
  constexpr double kStrong = 0.2;
  for (const double ratio : {0.5, 1.0, 2.0}) {
    const Motion motion = sine(1, ratio / kPeriod, 60, {.dt = 0.002, .duration = 60});
    const auto response = oscillator_response(motion, kPeriod, kStrong);
    double largest = 0;
    for (std::size_t i = 15000; i < 29000; ++i)
      largest = std::max(largest, std::abs(response.absolute_acceleration[i]));
    const double damper = 2 * kStrong * ratio, spring = 1 - ratio * ratio;
    const double expected = std::hypot(1, damper) / std::hypot(spring, damper);
    EXPECT_NEAR(largest / expected, 1, 1e-3) << ratio;
    if (ratio == 1) {  // reached from below
      const auto spectrum = response_spectrum(motion, std::vector{kPeriod}, kStrong);
      EXPECT_NEAR(spectrum.absolute_acceleration[0] / expected, 1, 1e-3);
    }
  }
}

// Without damping pseudo and absolute acceleration are the same.
TEST(Spectrum, PseudoIsAbsoluteWithoutDamping) {
  const auto spectrum =
      response_spectrum(ricker(2, 1, 2, {.dt = 0.01, .duration = 4}), logarithmic_periods(0.1, 3, 20), 0);
  for (std::size_t i = 0; i < 20; ++i)
    EXPECT_NEAR(spectrum.pseudo_acceleration[i], spectrum.absolute_acceleration[i], 1e-11);
}

// Periods have equal ratios and the ends that were asked for.
TEST(Spectrum, PeriodsHaveEqualRatios) {
  const auto periods = logarithmic_periods(0.1, 10, 3);
  EXPECT_DOUBLE_EQ(periods[0], 0.1);
  EXPECT_DOUBLE_EQ(periods[1], 1);
  EXPECT_DOUBLE_EQ(periods[2], 10);
}

// Every wrong argument is refused in words.
TEST(Spectrum, RefusesWrongArguments) {
  const Motion motion{0.01, {0, 1, 0}};
  EXPECT_THAT(complaint([&] { oscillator_response(motion, 0, 0.05); }),
              HasSubstr("period of the oscillator is 0"));
  EXPECT_THAT(complaint([&] { oscillator_response(motion, 1, 1); }),
              HasSubstr("damping ratio is 1; give one from 0"));
  EXPECT_THAT(complaint([&] { response_spectrum(motion, std::vector{-1.0}, 0.05); }),
              HasSubstr("a period of the spectrum is -1 s"));
  EXPECT_THAT(complaint([&] { response_spectrum(motion, std::vector{1.0}, -0.1); }),
              HasSubstr("damping ratio is -0.1"));
  EXPECT_THAT(complaint([] { logarithmic_periods(1, 0.5, 10); }),
              HasSubstr("from 1 s to 0.5 s are not a band"));
  EXPECT_THAT(complaint([] { logarithmic_periods(1, 2, 1); }), HasSubstr("1 periods are asked for"));
}

}  // namespace
}  // namespace adit::motion::test::response_test

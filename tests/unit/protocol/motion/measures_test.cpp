// Requirements on the measures of motions.
#include "protocol/motion/measures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocol/motion/synthesis/pulses.hpp"
#include "tests/unit/protocol/motion/support.hpp"

namespace adit::motion::test::measures_test {
namespace {

// PGA, PGV and PGD of whole cycles of a sine: A, 2 A/w and A T/w.
TEST(Measures, PeaksOfASine) {
  const double w = 2 * kPi * 2;
  const Peaks found = peaks(sine(3, 2, 5, {.dt = 0.0005, .duration = 5}));
  EXPECT_NEAR(found.acceleration, 3, 1e-9);
  EXPECT_NEAR(found.velocity, 6 / w, 1e-5);
  EXPECT_NEAR(found.displacement, 3 * 5 / w, 1e-4);
}

// Arias intensity of whole cycles of a sine: pi A^2 T / (4 g); of a constant, exact to rounding.
TEST(Measures, AriasIntensityOfASine) {
  EXPECT_NEAR(arias_intensity(sine(3, 2, 5, {.dt = 0.0005, .duration = 5})), kPi * 9 * 5 / (4 * 9.80665),
              1e-4);
  EXPECT_NEAR(arias_intensity({0.5, {2, 2, 2}}), kPi / (2 * 9.80665) * 4, 1e-14);
}

// With whole cycles of a sine over 5 s the Arias intensity grows evenly, so that 90 % of it take 4.5 s, and
// the cumulative absolute velocity is 2 A T / pi.
TEST(Measures, DurationAndCumulativeVelocityOfASine) {
  const Motion motion = sine(3, 2, 5, {.dt = 0.0005, .duration = 5});
  EXPECT_NEAR(significant_duration(motion, 0.05, 0.95), 4.5, 1e-3);
  EXPECT_NEAR(cumulative_absolute_velocity(motion), 2 * 3 * 5 / kPi, 1e-4);
  const auto course = husid(motion);
  EXPECT_NEAR(course[5000], 0.5, 1e-4);
  EXPECT_EQ(course.back(), 1);
}

// Both are exact for straight lines: a constant, and a line that crosses 0.
TEST(Measures, DurationAndCumulativeVelocityAreExactForStraightLines) {
  EXPECT_NEAR(significant_duration({0.5, {2, 2, 2}}, 0.05, 0.95), 0.9, 1e-14);
  EXPECT_NEAR(cumulative_absolute_velocity({0.5, {2, 2, -2, -2}}), 1 + 0.5 + 1, 1e-14);
  EXPECT_EQ(significant_duration({0.5, {0, 0, 0}}, 0.05, 0.95), 0);
  EXPECT_EQ(husid({0.5, {0, 0}}), (std::vector<double>{0, 0}));
}

// Shares that bound nothing are refused in words.
TEST(Measures, DurationRefusesWrongShares) {
  EXPECT_THAT(complaint([] {
                significant_duration({0.5, {1, 1}}, 0.95, 0.05);
              }),
              testing::HasSubstr("do not bound a duration; give two ascending shares from 0 to 1"));
}

// The Fourier spectrum of the Ricker motion is that of its formula:
//   |U| = 2 peak f^2 exp(-(f/f0)^2) / (sqrt(pi) f0^3).
TEST(Measures, FourierSpectrumOfRicker) {
  const double f0 = 2;
  const FourierSpectrum spectrum = fourier_spectrum(ricker(3, f0, 2, {.dt = 0.01, .duration = 4}));
  ASSERT_EQ(spectrum.frequency.size(), 257u);
  EXPECT_DOUBLE_EQ(spectrum.frequency.back(), 50);
  for (std::size_t k = 0; k < spectrum.frequency.size(); ++k) {
    const double f = spectrum.frequency[k];
    const double exact = 2 * 3 * f * f * std::exp(-f * f / (f0 * f0)) / (std::sqrt(kPi) * f0 * f0 * f0);
    EXPECT_NEAR(spectrum.amplitude[k], exact, 1e-9);
  }
}

// The energy is the same in time and frequency (Parseval).
TEST(Measures, FourierSpectrumKeepsTheEnergy) {
  const Motion motion{0.02, {0, 1, -3, 2, 5, -1, 0.5}};
  const FourierSpectrum spectrum = fourier_spectrum(motion);
  double time = 0, frequency = 0;
  for (const double a : motion.acceleration) time += a * a * motion.dt;
  for (std::size_t k = 0; k < spectrum.amplitude.size(); ++k) {
    const bool end = k == 0 || k + 1 == spectrum.amplitude.size();
    frequency += (end ? 1 : 2) * spectrum.amplitude[k] * spectrum.amplitude[k] * spectrum.frequency[1];
  }
  EXPECT_NEAR(frequency, time, 1e-13);
}

}  // namespace
}  // namespace adit::motion::test::measures_test

// Requirements on transfer functions.
#include "protocol/motion/spectra/transfer.hpp"

#include <gmock/gmock.h>

#include "protocol/motion/spectra/response.hpp"
#include "protocol/motion/synthesis/pulses.hpp"
#include "tests/unit/protocol/motion/support.hpp"

namespace adit::motion::test::transfer_test {
namespace {

using testing::HasSubstr;

// A motion three times as large is three times as large at every frequency.
TEST(Transfer, OfAMultipleIsTheFactor) {
  const Motion from = ricker(1, 2, 2, {.dt = 0.01, .duration = 8});
  Motion to = from;
  for (double& a : to.acceleration) a *= -3;
  const auto frequencies = logarithmic_periods(0.1, 6, 50);
  for (const double ratio : transfer_function(from, to, frequencies)) EXPECT_NEAR(ratio, 3, 1e-12);
}

// From the ground to the mass of an oscillator of 30 % damping it is the closed form
//   sqrt((1 + (2 d r)^2) / ((1 - r^2)^2 + (2 d r)^2)), r = f / f0,
// within 2 %, which the smoothing costs at the resonance.
TEST(Transfer, OfAnOscillatorIsTheClosedForm) {
  Motion from{0.005, std::vector<double>(8000)};
  from.acceleration[1] = 1;  // holds all frequencies alike
  const double damping = 0.3, f0 = 2;
  const Motion to{from.dt, oscillator_response(from, 1 / f0, damping).absolute_acceleration};
  const auto frequencies = logarithmic_periods(0.5, 6, 40);
  const auto found = transfer_function(from, to, frequencies);
  for (std::size_t k = 0; k < found.size(); ++k) {
    const double r = frequencies[k] / f0, lag = std::pow(2 * damping * r, 2);
    const double exact = std::sqrt((1 + lag) / (std::pow(1 - r * r, 2) + lag));
    EXPECT_NEAR(found[k] / exact, 1, 0.02) << frequencies[k];
  }
}

// Far below the first line of a short motion the spectrum is still smooth: that of the zeros around it.
TEST(Transfer, IsSmoothBetweenTheLinesOfAShortMotion) {
  const double f0 = 2;
  const auto frequencies = logarithmic_periods(0.1, 3, 60);
  const auto smooth = smoothed_amplitude(ricker(3, f0, 1, {.dt = 0.01, .duration = 2}), frequencies);
  for (std::size_t k = 0; k < smooth.size(); ++k) {
    const double f = frequencies[k];
    const double exact = 2 * 3 * f * f * std::exp(-f * f / (f0 * f0)) / (std::sqrt(kPi) * f0 * f0 * f0);
    EXPECT_NEAR(smooth[k] / exact, 1, 0.02) << f;
  }
}

// Motions that do not run together, and frequencies that are none, are refused in words.
TEST(Transfer, RefusesWrongArguments) {
  EXPECT_THAT(complaint([] {
                transfer_function({0.1, {1, 2}}, {0.2, {1, 2}}, std::vector{1.0});
              }),
              HasSubstr("2 values at 0.1 s and 2 values at 0.2 s"));
  EXPECT_THAT(complaint([] {
                smoothed_amplitude({0.1, {1, 2}}, std::vector{0.0});
              }),
              HasSubstr("frequency of the smoothed spectrum is 0"));
}

}  // namespace
}  // namespace adit::motion::test::transfer_test

// Requirements on the Butterworth filters.
#include "protocol/motion/processing/filter.hpp"

#include <gmock/gmock.h>

#include <complex>

#include "tests/unit/protocol/motion/support.hpp"

namespace adit::motion::test::filter_test {
namespace {

using testing::HasSubstr;

constexpr double kStep = 0.01;
constexpr std::size_t kCount = 8192;
constexpr std::size_t kImpulse = kCount / 2;
constexpr double kCorner = 5;

Motion impulse() {
  Motion motion{kStep, std::vector<double>(kCount)};
  motion.acceleration[kImpulse] = 1;
  return motion;
}

// The transfer function that the response to an impulse shows at a frequency.
std::complex<double> gain(const Motion& response, double frequency) {
  std::complex<double> sum = 0;
  for (std::size_t i = 0; i < kCount; ++i)
    sum += response.acceleration[i] *
           std::polar(
               1.0, -2 * kPi * frequency * kStep * (static_cast<double>(i) - static_cast<double>(kImpulse)));
  return sum;
}

// The frequency that the bilinear transform takes for `frequency`, corner kept.
double warped(double frequency) {
  return kCorner * std::tan(kPi * frequency * kStep) / std::tan(kPi * kCorner * kStep);
}

// Both phases: -3 dB at the corner for every order, low and high pass, and the Butterworth gain elsewhere.
TEST(Filter, HasTheButterworthGain) {
  for (const int order : {1, 2, 3, 4, 7}) {
    for (const auto phase : {Phase::kZero, Phase::kCausal}) {
      const Motion low = low_pass(impulse(), kCorner, order, phase);
      const Motion high = high_pass(impulse(), kCorner, order, phase);
      EXPECT_NEAR(20 * std::log10(std::abs(gain(low, kCorner))), -10 * std::log10(2), 1e-4) << order;
      EXPECT_NEAR(20 * std::log10(std::abs(gain(high, kCorner))), -10 * std::log10(2), 1e-4) << order;
      for (const double f : {0.5, 2.0, 4.0, 8.0, 20.0}) {
        const double power = std::pow((phase == Phase::kZero ? f : warped(f)) / kCorner, 2 * order);
        EXPECT_NEAR(std::abs(gain(low, f)), std::sqrt(1 / (1 + power)), 1e-5) << order << ' ' << f;
        EXPECT_NEAR(std::abs(gain(high, f)), std::sqrt(power / (1 + power)), 1e-5) << order << ' ' << f;
      }
    }
  }
}

// The zero-phase filter delays no frequency: its response to an impulse is symmetric about it.
TEST(Filter, ZeroPhaseIsSymmetric) {
  const Motion response = low_pass(high_pass(impulse(), 1, 4, Phase::kZero), 10, 4, Phase::kZero);
  for (std::size_t i = 1; i < 1000; ++i)
    EXPECT_NEAR(response.acceleration[kImpulse + i], response.acceleration[kImpulse - i], 1e-9);
}

// The causal filter does nothing before its cause.
TEST(Filter, CausalRespondsAfterItsCause) {
  const Motion response = low_pass(high_pass(impulse(), 1, 5, Phase::kCausal), 10, 5, Phase::kCausal);
  for (std::size_t i = 0; i < kImpulse; ++i) ASSERT_EQ(response.acceleration[i], 0);
  EXPECT_NE(response.acceleration[kImpulse], 0);
}

// What the filter puts before the begin of the motion does not come back at its end.
TEST(Filter, ZeroPhaseDoesNotWrapAround) {
  Motion motion{kStep, std::vector<double>(kCount)};
  motion.acceleration[0] = 1;
  EXPECT_LT(std::abs(low_pass(motion, kCorner, 4, Phase::kZero).acceleration.back()), 1e-9);
}

// Every wrong corner or order is refused in words.
TEST(Filter, RefusesWrongArguments) {
  const auto low = [](double corner, int order) {
    return complaint([=] { low_pass(impulse(), corner, order, Phase::kZero); });
  };
  EXPECT_THAT(low(0, 4), HasSubstr("corner frequency of the filter is 0; give a value above 0"));
  EXPECT_THAT(low(-1, 4), HasSubstr("corner frequency of the filter is -1"));
  EXPECT_THAT(low(50, 4), HasSubstr("at steps of 0.01 s give one below 50 Hz"));
  EXPECT_THAT(low(5, 0), HasSubstr("order of the filter is 0; give one from 1 to 20"));
}

}  // namespace
}  // namespace adit::motion::test::filter_test

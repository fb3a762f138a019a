// Requirement: between its values a record keeps its amplitude at every frequency below 0.9 of its Nyquist
// frequency.
#include <gtest/gtest.h>

#include <cmath>

#include "protocol/motion/processing/processing.hpp"
#include "protocol/motion/velocity_history.hpp"
#include "tests/unit/protocol/motion/support.hpp"

namespace adit::motion::test::refined_test {
namespace {

constexpr int kParts = 8;

// The amplitude of the velocity at the frequency of a long sine, over that of the sine itself: by projection
// onto its sine and cosine over whole periods in the middle, at steps that no sample meets.
double kept(double dt, double frequency, bool refine) {
  const double w = 2 * kPi * frequency, length = 10;
  const Motion record = tapered(sampled(dt, static_cast<std::size_t>(std::lround(length / dt)) + 1,
                                        [=](double t) { return std::sin(w * t); }),
                                2, 2);
  const VelocityHistory velocity(refine ? refined(record, kParts) : record);
  const double begin = 4, h = 1 / frequency / 397;
  double sine = 0, cosine = 0;
  const int count = 397 * static_cast<int>(2 * frequency);
  for (int i = 0; i < count; ++i) {
    const double t = begin + i * h;
    sine += velocity(t) * std::sin(w * t);
    cosine += velocity(t) * std::cos(w * t);
  }
  return 2 * w * std::hypot(sine, cosine) / count;
}

// The theory of straight lines: sinc^2 of frequency times step.
double of_lines(double steps) {
  return std::pow(std::sin(kPi * steps) / (kPi * steps), 2);
}

TEST(Refined, KeepsTheAmplitudesThatStraightLinesLose) {
  for (const double frequency : {20.0, 40.0}) {
    EXPECT_NEAR(kept(0.005, frequency, false), of_lines(0.005 * frequency), 1e-4);  // 0.968, 0.875
    EXPECT_NEAR(kept(0.005, frequency, true), of_lines(0.005 * frequency / kParts), 2e-4);
  }
  EXPECT_NEAR(kept(0.005, 20, true), 1, 0.0006);
  EXPECT_NEAR(kept(0.005, 40, true), 1, 0.0025);
  EXPECT_NEAR(kept(0.005, 90, true), 1, 0.012);
  EXPECT_NEAR(kept(0.02, 20, true), 1, 0.01);
}

// The given values stay, and so do velocity and displacement at the end, also where the motion begins and
// ends with a jump.
TEST(Refined, KeepsTheValuesAndTheEnd) {
  const Motion motion = sampled(0.01, 501, [](double t) { return std::cos(40 * t) + 0.2; });
  const Motion fine = refined(motion, kParts);
  ASSERT_EQ(fine.acceleration.size(), 4001U);
  EXPECT_DOUBLE_EQ(fine.dt, 0.00125);
  for (std::size_t i = 0; i < motion.acceleration.size(); ++i)
    EXPECT_NEAR(fine.acceleration[8 * i], motion.acceleration[i], 0.01);
  const Course before = integrate(motion), after = integrate(fine);
  EXPECT_NEAR(after.velocity.back(), before.velocity.back(), 1e-12);
  EXPECT_NEAR(after.displacement.back(), before.displacement.back(), 1e-11);
}

}  // namespace
}  // namespace adit::motion::test::refined_test

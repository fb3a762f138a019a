// Requirements on the preparation of motions.
#include "protocol/motion/processing/processing.hpp"

#include <gmock/gmock.h>

#include "protocol/motion/measures.hpp"
#include "tests/unit/protocol/motion/support.hpp"

namespace adit::motion::test::processing_test {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

const Motion kCount{0.5, {0, 1, 2, 3, 4}};

// A cut keeps the values from its begin to its end; padding puts zeros before and after.
TEST(Processing, CutsAndPads) {
  EXPECT_THAT(cut(kCount, 0.5, 1.5).acceleration, ElementsAre(1, 2, 3));
  EXPECT_THAT(cut(kCount, 0, 2).acceleration, ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(padded(kCount, 0.5, 1).acceleration, ElementsAre(0, 0, 1, 2, 3, 4, 0, 0));
}

// The taper is half a cosine at each end and leaves the middle alone.
TEST(Processing, TapersByHalfACosine) {
  const Motion tapered_ones = tapered(sampled(0.1, 101, [](double) { return 1.0; }), 2, 4);
  for (std::size_t i = 0; i <= 100; ++i) {
    const double t = 0.1 * static_cast<double>(i);
    const double expected = t < 2   ? (1 - std::cos(kPi * t / 2)) / 2
                            : t > 6 ? (1 - std::cos(kPi * (10 - t) / 4)) / 2
                                    : 1;
    EXPECT_NEAR(tapered_ones.acceleration[i], expected, 1e-12);
  }
}

// Scaling reaches the peak asked for and keeps the sign.
TEST(Processing, ScalesToAPeak) {
  EXPECT_THAT(scaled_to_peak({0.5, {0, 1, -4}}, 2).acceleration, ElementsAre(0, 0.5, -2));
}

// After the correction any motion ends at rest and in its place, and its first and last value are kept.
TEST(Processing, BaselineCorrectionEndsAtRest) {
  const Motion motion = sampled(0.01, 4001, [](double t) { return 0.3 + std::sin(3 * t) - 0.01 * t; });
  const Motion corrected = baseline_corrected(motion);
  const Course course = integrate(corrected);
  EXPECT_NEAR(course.velocity.back(), 0, 1e-11);
  EXPECT_NEAR(course.displacement.back(), 0, 1e-10);
  EXPECT_EQ(corrected.acceleration.front(), motion.acceleration.front());
  EXPECT_EQ(corrected.acceleration.back(), motion.acceleration.back());
}

// A motion that ends at rest and in its place already is not changed.
TEST(Processing, BaselineCorrectionKeepsWhatIsRight) {
  const double w = 2 * kPi;
  // The second derivative of sin^4, whose discrete integral is also zero at the end of a period.
  Motion motion = sampled(0.01, 101, [&](double t) { return std::cos(w * t) - std::cos(2 * w * t); });
  const Motion corrected = baseline_corrected(motion);
  EXPECT_LT(largest_difference(motion.acceleration, corrected.acceleration, 0, 101), 1e-12);
}

// On the straight lines between the values, resampling is exact, to finer and to coarser steps.
TEST(Resampling, LinearStaysOnTheStraightLines) {
  EXPECT_THAT(resampled(kCount, 0.25, Interpolation::kLinear).acceleration,
              ElementsAre(0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4));
  EXPECT_THAT(resampled(kCount, 1, Interpolation::kLinear).acceleration, ElementsAre(0, 2, 4));
}

double packet(double frequency, double t) {
  return std::exp(-std::pow((t - 5) / 1.2, 2)) * std::sin(2 * kPi * frequency * t);
}

// Frequencies below 0.9 of Nyquist come through band-limited resampling to 1e-4, at an odd ratio of steps.
TEST(Resampling, BandLimitedKeepsFrequenciesBelowNyquist) {
  for (const double frequency : {1.0, 20.0, 44.0}) {
    const Motion fine = resampled(sampled(0.01, 1001, [&](double t) { return packet(frequency, t); }), 0.0037,
                                  Interpolation::kBandLimited);
    const Motion exact =
        sampled(0.0037, fine.acceleration.size(), [&](double t) { return packet(frequency, t); });
    EXPECT_LT(largest_difference(fine.acceleration, exact.acceleration, 0, fine.acceleration.size()), 1e-4);
  }
}

// What lies above the new Nyquist frequency is removed; linear interpolation lets it fold back.
TEST(Resampling, BandLimitedRemovesWhatTheNewStepCannotShow) {
  const Motion motion = sampled(0.01, 1001, [](double t) { return packet(15, t); });
  EXPECT_LT(peaks(resampled(motion, 0.04, Interpolation::kBandLimited)).acceleration, 1e-4);
  EXPECT_GT(peaks(resampled(motion, 0.04, Interpolation::kLinear)).acceleration, 0.5);
  EXPECT_NEAR(peaks(resampled(sampled(0.01, 1001, [](double t) { return packet(11, t); }), 0.04,
                              Interpolation::kBandLimited))
                  .acceleration,
              1, 0.02);
}

// The same step returns the same motion, bit by bit.
TEST(Resampling, SameStepChangesNothing) {
  const Motion motion = sampled(0.01, 1001, [](double t) { return packet(7, t); });
  for (const auto interpolation : {Interpolation::kLinear, Interpolation::kBandLimited})
    EXPECT_EQ(resampled(motion, 0.01, interpolation).acceleration, motion.acceleration);
}

// A constant stays constant away from the ends, whatever the ratio.
TEST(Resampling, KeepsAConstant) {
  const Motion result =
      resampled(sampled(0.01, 1001, [](double) { return 1.0; }), 0.017, Interpolation::kBandLimited);
  EXPECT_THAT(std::vector(result.acceleration.begin() + 60, result.acceleration.end() - 60),
              Each(testing::DoubleNear(1, 1e-12)));
}

// Every wrong argument is refused in words.
TEST(Processing, RefusesWrongArguments) {
  EXPECT_THAT(complaint([] { cut(kCount, 0, 3); }), HasSubstr("lasts 2 s, but 3 s are asked for"));
  EXPECT_THAT(complaint([] { cut(kCount, 1, 1); }), HasSubstr("the cut ends at 1 s and begins at 1 s"));
  EXPECT_THAT(complaint([] { cut(kCount, -1, 1); }), HasSubstr("begin of the cut is -1 s"));
  EXPECT_THAT(complaint([] { padded(kCount, 0, -1); }), HasSubstr("pad after the motion is -1 s"));
  EXPECT_THAT(complaint([] { padded(kCount, 1e300, 0); }), HasSubstr("give a shorter time"));
  EXPECT_THAT(complaint([] { tapered(kCount, 1.5, 1); }), HasSubstr("overlap in a motion of 2 s"));
  EXPECT_THAT(complaint([] { scaled_to_peak(kCount, 0); }), HasSubstr("peak acceleration to scale to is 0"));
  EXPECT_THAT(complaint([] { scaled_to_peak({1, {0, 0}}, 1); }), HasSubstr("zero throughout"));
  EXPECT_THAT(complaint([] { baseline_corrected({1, {0, 0, 1}}); }), HasSubstr("fewer than 4 values"));
  EXPECT_THAT(complaint([] { resampled(kCount, 0, Interpolation::kLinear); }), HasSubstr("resample to is 0"));
  EXPECT_THAT(complaint([] { resampled(kCount, 1e-20, Interpolation::kLinear); }),
              HasSubstr("more than 1e8 values"));
}

}  // namespace
}  // namespace adit::motion::test::processing_test

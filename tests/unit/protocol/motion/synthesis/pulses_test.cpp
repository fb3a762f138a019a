// Requirements on pulses.
#include "protocol/motion/synthesis/pulses.hpp"

#include <gmock/gmock.h>

#include "protocol/motion/measures.hpp"
#include "tests/unit/protocol/motion/support.hpp"

namespace adit::motion::test::pulses_test {
namespace {

using testing::HasSubstr;

constexpr Sampling kSampling{.dt = 0.001, .duration = 4};

// The displacement of the Ricker motion is the Gaussian of its formula: it returns to its place.
TEST(Ricker, HasAGaussianDisplacement) {
  const Motion motion = ricker(3, 2, 2, kSampling);
  ASSERT_EQ(motion.acceleration.size(), 4001u);
  EXPECT_EQ(motion.acceleration[2000], 3);
  const Course course = integrate(motion);
  for (std::size_t i = 0; i <= 4000; i += 50) {
    const double x = kPi * 2 * (0.001 * static_cast<double>(i) - 2);
    EXPECT_NEAR(course.displacement[i], -3 * std::exp(-x * x) / (2 * kPi * kPi * 4), 1e-6);
  }
}

// The sine ends where asked and has the velocity (1 - cos) / w until then.
TEST(Sine, EndsWhereAsked) {
  const Motion motion = sine(2, 1.5, 2, kSampling);
  const Course course = integrate(motion);
  const double w = 3 * kPi;
  for (std::size_t i = 0; i <= 2000; i += 40)
    EXPECT_NEAR(course.velocity[i], 2 * (1 - std::cos(w * 0.001 * static_cast<double>(i))) / w, 2e-5);
  for (std::size_t i = 2001; i <= 4000; ++i) ASSERT_EQ(motion.acceleration[i], 0);
}

// The spectrum of the Gabor motion peaks at its carrier, and its envelope falls by e over the width.
TEST(Gabor, HasItsCarrierAndWidth) {
  const Motion motion = gabor(2, 5, 6 * kPi, 0, 2, kSampling);
  const FourierSpectrum spectrum = fourier_spectrum(motion);
  const auto top = std::ranges::max_element(spectrum.amplitude) - spectrum.amplitude.begin();
  EXPECT_NEAR(spectrum.frequency[static_cast<std::size_t>(top)], 5, spectrum.frequency[1]);
  EXPECT_EQ(motion.acceleration[2000], 2);
  // Three cycles, 0.6 s, from the centre.
  EXPECT_NEAR(motion.acceleration[2600], 2 / std::exp(1), 1e-9);
  EXPECT_NEAR(gabor(2, 5, 6 * kPi, kPi / 2, 2, kSampling).acceleration[2000], 0, 1e-12);
}

// Every wrong argument is refused in words.
TEST(Pulses, RefuseWrongArguments) {
  EXPECT_THAT(complaint([] { ricker(1, 0, 1, kSampling); }),
              HasSubstr("frequency of the motion is 0; give a value above 0"));
  EXPECT_THAT(complaint([] { sine(1, -2, 1, kSampling); }), HasSubstr("frequency of the motion is -2"));
  EXPECT_THAT(complaint([] { sine(1, 500, 1, kSampling); }), HasSubstr("give one below 500 Hz"));
  EXPECT_THAT(complaint([] { sine(1, 1, 0, kSampling); }), HasSubstr("end of the sine is 0"));
  EXPECT_THAT(complaint([] { gabor(1, 1, 0, 0, 1, kSampling); }), HasSubstr("width of the motion is 0"));
  EXPECT_THAT(complaint([] { ricker(1, 1, 1, {0, 1}); }), HasSubstr("time step of the motion is 0"));
  EXPECT_THAT(complaint([] { ricker(1, 1, 1, {0.01, -1}); }), HasSubstr("duration of the motion is -1"));
  EXPECT_THAT(complaint([] { ricker(NAN, 1, 1, kSampling); }), HasSubstr("peak of the motion is nan"));
}

}  // namespace
}  // namespace adit::motion::test::pulses_test

// Requirements on target spectra and on the motions made to follow them.
#include "protocol/motion/synthesis/synthetic.hpp"

#include <gmock/gmock.h>

#include "protocol/motion/measures.hpp"
#include "protocol/motion/random.hpp"
#include "protocol/motion/spectra/response.hpp"
#include "tests/unit/protocol/motion/support.hpp"

namespace adit::motion::test::synthetic_test {
namespace {

using testing::HasSubstr;

SyntheticRequest request(TargetSpectrum target, std::uint64_t seed) {
  return {.target = std::move(target),
          .shortest_period = 0.05,
          .longest_period = 4,
          .dt = 0.01,
          .duration = 40,
          .envelope = {.rise = 4, .decay = 18, .rate = 0.2},
          .seed = seed};
}

// The stream of random numbers is the one the C++ standard fixes: its 10000th raw number is known.
TEST(Random, IsTheSameEverywhere) {
  Random random(std::mt19937_64::default_seed);
  double value = 0;
  for (int i = 0; i < 10000; ++i) value = random.uniform();
  EXPECT_EQ(value, static_cast<double>(9981545732273789042ULL >> 11) / 9007199254740992.0);
}

// The complex Gaussian has mean zero and mean square one.
TEST(Random, ComplexGaussianHasUnitMeanSquare) {
  Random random(3);
  std::complex<double> mean = 0;
  double square = 0;
  for (int i = 0; i < 100000; ++i) {
    const auto z = random.complex_gaussian();
    mean += z / 1e5;
    square += std::norm(z) / 1e5;
  }
  EXPECT_LT(std::abs(mean), 0.015);
  EXPECT_NEAR(square, 1, 0.015);
}

// GB 18306: peak at zero, plateau of 2.5 from 0.1 s to Tg, then falling with the period.
TEST(Target, Gb18306HasItsShape) {
  const auto target = gb18306(2, 0.45);
  EXPECT_DOUBLE_EQ(target(0), 2);
  EXPECT_DOUBLE_EQ(target(0.05), 3.5);
  EXPECT_DOUBLE_EQ(target(0.1), 5);
  EXPECT_DOUBLE_EQ(target(0.45), 5);
  EXPECT_DOUBLE_EQ(target(0.9), 2.5);
}

// Eurocode 8, type 1: each branch, and the branches meet, on every ground.
TEST(Target, Ec8HasItsShape) {
  const auto soft = ec8_type1(2, GroundType::kD);
  EXPECT_DOUBLE_EQ(soft(0), 2.7);
  EXPECT_DOUBLE_EQ(soft(0.5), 6.75);
  EXPECT_DOUBLE_EQ(soft(1.6), 3.375);
  EXPECT_DOUBLE_EQ(soft(4), 6.75 * 0.8 * 2 / 16);
  for (const auto ground : {GroundType::kA, GroundType::kB, GroundType::kC, GroundType::kD, GroundType::kE}) {
    const auto target = ec8_type1(1, ground);
    for (double period = 0.001; period < 4; period += 0.001)
      ASSERT_NEAR(target(period), target(period - 0.001), 0.035);
  }
}

// The response of synthetic motions follows the target over the band: the mean misfit is below 4 % and the
// largest below 20 %, for both codes and several seeds. The misfit that is reported is that of the motion.
TEST(Synthetic, FollowsTheTarget) {
  for (const auto& target : {gb18306(1.5, 0.45), ec8_type1(2, GroundType::kB)})
    for (const std::uint64_t seed : {1, 2, 3}) {
      const SyntheticMotion result = synthesize(request(target, seed));
      const auto spectrum =
          response_spectrum(result.motion, logarithmic_periods(0.05, 4, kControlPeriods), 0.05);
      double mean = 0, largest = 0;
      for (std::size_t i = 0; i < kControlPeriods; ++i) {
        const double misfit = std::abs(spectrum.pseudo_acceleration[i] / target(spectrum.period[i]) - 1);
        mean += misfit / kControlPeriods;
        largest = std::max(largest, misfit);
      }
      std::printf("seed %d: mean misfit %.2f %%, largest %.2f %%, iteration %d\n", static_cast<int>(seed),
                  100 * mean, 100 * largest, result.iterations);
      EXPECT_NEAR(result.mean_misfit, mean, 1e-12);
      EXPECT_NEAR(result.max_misfit, largest, 1e-12);
      EXPECT_LT(mean, 0.04);
      EXPECT_LT(largest, 0.2);
    }
}

// A synthetic motion ends at rest and in its place, lasts as long as asked, and keeps its envelope.
TEST(Synthetic, EndsAtRestUnderItsEnvelope) {
  const Motion motion = synthesize(request(gb18306(1, 0.35), 7)).motion;
  EXPECT_NEAR(motion.duration(), 40, 1e-9);
  const Course course = integrate(motion);
  EXPECT_NEAR(course.velocity.back(), 0, 1e-10);
  EXPECT_NEAR(course.displacement.back(), 0, 1e-9);
  const auto energy = [&](std::size_t first, std::size_t end) {
    double sum = 0;
    for (std::size_t i = first; i < end; ++i) sum += motion.acceleration[i] * motion.acceleration[i];
    return sum;
  };
  EXPECT_LT(energy(0, 100) + energy(3500, 4001), 0.02 * energy(0, 4001));
}

// The same seed gives the same bits, another seed another motion.
TEST(Synthetic, IsFixedByItsSeed) {
  auto asked = request(gb18306(1, 0.35), 11);
  asked.iterations = 3;
  const auto first = synthesize(asked).motion.acceleration;
  EXPECT_EQ(first, synthesize(asked).motion.acceleration);
  asked.seed = 12;
  EXPECT_NE(first, synthesize(asked).motion.acceleration);
}

// Every wrong request is refused in words.
TEST(Synthetic, RefusesWrongRequests) {
  const auto refused = [](auto change) {
    auto asked = request(gb18306(1, 0.35), 1);
    change(asked);
    return complaint([&] { synthesize(asked); });
  };
  EXPECT_THAT(refused([](auto& r) { r.dt = 0; }), HasSubstr("time step of the synthetic motion is 0"));
  EXPECT_THAT(refused([](auto& r) { r.duration = -1; }), HasSubstr("duration of the synthetic motion is -1"));
  EXPECT_THAT(refused([](auto& r) { r.shortest_period = 0.03; }), HasSubstr("give at least 0.04 s"));
  EXPECT_THAT(refused([](auto& r) { r.longest_period = 14; }),
              HasSubstr("at most a third of the duration, 13.3333 s"));
  EXPECT_THAT(refused([](auto& r) { r.envelope.decay = 50; }), HasSubstr("0 <= rise <= decay <= duration"));
  EXPECT_THAT(refused([](auto& r) { r.iterations = 0; }), HasSubstr("give at least 1"));
  EXPECT_THAT(refused([](auto& r) { r.target = nullptr; }), HasSubstr("has no target spectrum"));
  EXPECT_THAT(refused([](auto& r) { r.target = [](double) { return 0.0; }; }),
              HasSubstr("the target spectrum at 0.05 s is 0"));
  EXPECT_THAT(complaint([] { gb18306(0, 0.35); }), HasSubstr("peak acceleration of the spectrum is 0"));
  EXPECT_THAT(complaint([] { gb18306(1, 0.1); }), HasSubstr("characteristic period is 0.1 s"));
  EXPECT_THAT(complaint([] { ec8_type1(-1, GroundType::kA); }),
              HasSubstr("ground acceleration of the spectrum is -1"));
}

}  // namespace
}  // namespace adit::motion::test::synthetic_test

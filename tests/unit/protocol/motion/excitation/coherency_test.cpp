// Requirements on the loss of coherency between stations.
#include <gmock/gmock.h>

#include <complex>
#include <numeric>

#include "protocol/motion/excitation/stations.hpp"
#include "protocol/motion/fourier.hpp"
#include "protocol/motion/measures.hpp"
#include "protocol/motion/random.hpp"
#include "protocol/motion/synthesis/pulses.hpp"
#include "tests/unit/protocol/motion/support.hpp"

namespace adit::motion::test::coherency_test {
namespace {

constexpr double kDrift = 2.5e-4;
constexpr double kStep = 0.02;
constexpr std::size_t kCount = 1024;
constexpr int kSeeds = 400;

// Shaking of 20 s with all frequencies.
Motion noise(std::uint64_t seed) {
  Random random(seed);
  return sampled(kStep, kCount,
                 [&](double t) { return std::sin(kPi * t / 20.48) * random.complex_gaussian().real(); });
}

// Over many seeds, the coherency between any two of three stations is that of Luco and Wong, at frequencies
// where it is high and where it is low; four standard deviations of the estimate are allowed.
TEST(Coherency, IsThatOfTheModel) {
  const std::vector chainages{0.0, 100.0, 250.0};
  const std::vector<double> frequencies{1, 2, 4, 8};
  std::vector<std::complex<double>> cross(12);
  std::vector<double> power(12);
  for (int seed = 0; seed < kSeeds; ++seed) {
    const auto stations = station_motions(noise(1000 + static_cast<std::uint64_t>(seed)), chainages,
                                          {.drift = kDrift, .seed = static_cast<std::uint64_t>(seed)});
    std::vector<std::vector<std::complex<double>>> spectra;
    for (const Motion& station : stations) spectra.push_back(transform(station.acceleration, kCount));
    for (std::size_t f = 0; f < 4; ++f) {
      const auto bin = static_cast<std::size_t>(std::lround(frequencies[f] * kStep * kCount));
      for (std::size_t j = 0; j < 3; ++j) {
        const std::size_t k = (j + 1) % 3;
        cross[3 * f + j] += spectra[j][bin] * std::conj(spectra[k][bin]);
        power[3 * f + j] += std::norm(spectra[j][bin]);
      }
    }
  }
  for (std::size_t f = 0; f < 4; ++f)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t k = (j + 1) % 3;
      const double found = std::abs(cross[3 * f + j]) / std::sqrt(power[3 * f + j] * power[3 * f + k]);
      const double wanted = luco_wong(kDrift, frequencies[f], chainages[j] - chainages[k]);
      std::printf("%g Hz, %g m: coherency %.3f, model %.3f\n", frequencies[f],
                  std::abs(chainages[j] - chainages[k]), found, wanted);
      const double deviation = (1 - wanted * wanted) / std::sqrt(2.0 * kSeeds);
      // 0.01: the windows of the segments blur neighbouring frequencies.
      EXPECT_NEAR(found, wanted, 4 * deviation + 0.01) << frequencies[f] << " Hz";
      // The power of a station is that of the given motion, to three standard deviations.
      EXPECT_NEAR(power[3 * f + j] / power[3 * f], 1, 0.25) << frequencies[f] << " Hz";
    }
}

// The model itself: one at the same place, 1/e where drift w d is one.
TEST(Coherency, ModelHasItsScale) {
  EXPECT_EQ(luco_wong(kDrift, 5, 0), 1);
  EXPECT_NEAR(luco_wong(kDrift, 5, 1 / (kDrift * 2 * kPi * 5)), std::exp(-1), 1e-15);
}

// The station met first keeps the given motion, stations at the same place move alike, all end where it ends.
TEST(Coherency, ReferenceKeepsTheMotionAndAllEndAlike) {
  const Motion motion = gabor(1, 2, 20, 0, 5, {.dt = 0.02, .duration = 20});
  const auto stations =
      station_motions(motion, std::vector{0.0, 300.0, 300.0, 0.0}, {.drift = kDrift, .seed = 5});
  EXPECT_EQ(stations[0].acceleration, motion.acceleration);
  EXPECT_EQ(stations[3].acceleration, motion.acceleration);
  EXPECT_LT(
      largest_difference(stations[1].acceleration, stations[2].acceleration, 0, motion.acceleration.size()),
      1e-6);
  EXPECT_GT(
      largest_difference(stations[0].acceleration, stations[1].acceleration, 0, motion.acceleration.size()),
      0.1);
  const Course given = integrate(motion), other = integrate(stations[1]);
  EXPECT_NEAR(other.velocity.back(), given.velocity.back(), 1e-12);
  EXPECT_NEAR(other.displacement.back(), given.displacement.back(), 1e-11);
}

// The incoherent part stays where the shaking is: nothing moves before a segment's length ahead of it.
TEST(Coherency, ShakingKeepsItsPlaceInTime) {
  const Motion motion = gabor(1, 4, 10, 0, 20, {.dt = 0.02, .duration = 40});
  const auto far = station_motions(motion, std::vector{0.0, 2000.0}, {.drift = kDrift, .seed = 5})[1];
  double early = 0, all = 0;
  for (std::size_t i = 0; i < far.acceleration.size(); ++i) {
    all += far.acceleration[i] * far.acceleration[i];
    if (i < 600) early += far.acceleration[i] * far.acceleration[i];
  }
  EXPECT_GT(all, 0);
  EXPECT_LT(early, 1e-3 * all);
}

// The field is the same however many stations look at it.
TEST(Coherency, MoreStationsBetweenChangeNoMotion) {
  const Motion motion = gabor(1, 2, 20, 0, 3, {.dt = 0.02, .duration = 6});
  const NonUniform excitation{.apparent_velocity = 800, .drift = kDrift, .seed = 3};
  const auto few = station_motions(motion, std::vector{0.0, 400.0}, excitation),
             many = station_motions(motion, std::vector{0.0, 100.0, 200.0, 300.0, 400.0}, excitation);
  EXPECT_LT(largest_difference(few[1].acceleration, many[4].acceleration, 0, few[1].acceleration.size()),
            1e-12);
}

// Stations as close as soil columns along a tunnel shake with the power of the given motion, in the mean over
// 140 of them; the mean is of some hundred independent values.
TEST(Coherency, ManyCloseStationsKeepThePower) {
  const Motion motion = noise(1);
  std::vector<double> chainages;
  for (int j = 0; j <= 140; ++j) chainages.push_back(40.0 * j);
  const auto power = [](const Motion& of) {
    return std::inner_product(of.acceleration.begin(), of.acceleration.end(), of.acceleration.begin(), 0.0);
  };
  double sum = 0;
  for (const Motion& station : station_motions(motion, chainages, {.drift = kDrift, .seed = 3}))
    sum += power(station);
  EXPECT_NEAR(sum / static_cast<double>(chainages.size()), power(motion), 0.1 * power(motion));
}

// The same seed gives the same bits, another seed another motion; stations close by move alike.
TEST(Coherency, IsFixedByItsSeedAlsoForCloseStations) {
  const Motion motion = gabor(1, 2, 20, 0, 3, {.dt = 0.02, .duration = 6});
  std::vector<double> chainages;
  for (int j = 0; j < 40; ++j) chainages.push_back(0.5 * j);
  const auto last = [&](std::uint64_t seed) {
    return station_motions(motion, chainages, {.apparent_velocity = 800, .drift = kDrift, .seed = seed})
        .back();
  };
  EXPECT_EQ(last(1).acceleration, last(1).acceleration);
  EXPECT_NE(last(1).acceleration, last(2).acceleration);
  EXPECT_NEAR(peaks(last(1)).acceleration, 1, 0.2);
}

}  // namespace
}  // namespace adit::motion::test::coherency_test

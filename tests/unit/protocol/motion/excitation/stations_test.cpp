// Requirements on travelling waves.
#include "protocol/motion/excitation/stations.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "protocol/motion/processing/processing.hpp"
#include "protocol/motion/synthesis/pulses.hpp"
#include "tests/unit/protocol/motion/support.hpp"

namespace adit::motion::test::stations_test {
namespace {

using testing::HasSubstr;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// All stations move as the given motion where the wave is infinitely fast and coherent.
TEST(Stations, MoveAlikeUnderAUniformMotion) {
  const Motion motion = ricker(1, 2, 1, {.dt = 0.01, .duration = 3});
  for (const Motion& station : station_motions(motion, std::vector{0.0, 100.0, 5000.0}, {}))
    EXPECT_EQ(station.acceleration, motion.acceleration);
}

// Each station has the motion delayed by its distance over the apparent velocity, to 1e-4 of the peak between
// the steps, also at half a step where linear interpolation would lose 30 % at half the Nyquist frequency.
TEST(Stations, AreDelayedByTheirDistance) {
  const double velocity = 1000, frequency = 25;
  const Motion motion = gabor(1, frequency, 40, 0, 1, {.dt = 0.01, .duration = 2});
  const std::vector chainages{200.0, 203.7, 205.0, 1200.0, 5664.0};
  const auto stations = station_motions(motion, chainages, {.apparent_velocity = velocity});
  for (std::size_t j = 0; j < chainages.size(); ++j) {
    const double delay = (chainages[j] - 200) / velocity;
    ASSERT_EQ(stations[j].acceleration.size(), stations[0].acceleration.size());
    EXPECT_GE(stations[j].duration(), 2 + 5.464 - 1e-9);
    const Motion exact = sampled(0.01, stations[j].acceleration.size(), [&](double t) {
      const double angle = 2 * kPi * frequency * (t - delay - 1);
      return std::exp(-(angle / 40) * (angle / 40)) * std::cos(angle);
    });
    EXPECT_LT(largest_difference(stations[j].acceleration, exact.acceleration, 0, exact.acceleration.size()),
              1e-4)
        << chainages[j];
  }
}

// A delay of whole steps moves the values without changing a bit.
TEST(Stations, WholeStepsAreExact) {
  const Motion motion{0.1, {0, 1, 5, -2}};
  const auto stations = station_motions(motion, std::vector{0.0, 30.0}, {.apparent_velocity = 100});
  EXPECT_EQ(stations[0].acceleration, (std::vector<double>{0, 1, 5, -2, 0, 0, 0}));
  EXPECT_EQ(stations[1].acceleration, (std::vector<double>{0, 0, 0, 0, 1, 5, -2}));
}

// A wave towards smaller chainages meets the largest first, wherever the stations stand in the list.
TEST(Stations, NegativeVelocityRunsBackwards) {
  const Motion motion{0.1, {0, 1, 5, -2}};
  const auto stations = station_motions(motion, std::vector{0.0, 10.0, -10.0}, {.apparent_velocity = -100});
  EXPECT_EQ(stations[1].acceleration, (std::vector<double>{0, 1, 5, -2, 0, 0}));
  EXPECT_EQ(stations[0].acceleration, (std::vector<double>{0, 0, 1, 5, -2, 0}));
  EXPECT_EQ(stations[2].acceleration, (std::vector<double>{0, 0, 0, 1, 5, -2}));
}

// A delay in time and back returns the motion.
TEST(Delayed, BackAndForthReturnsTheMotion) {
  const Motion motion = gabor(1, 20, 20, 0, 1, {.dt = 0.01, .duration = 2});
  const Motion there = delayed(motion, 0.1234, 300);
  const Motion back = delayed(there, -0.1234, motion.acceleration.size());
  EXPECT_LT(largest_difference(back.acceleration, motion.acceleration, 0, motion.acceleration.size()), 2e-4);
}

// Every wrong argument is refused in words.
TEST(Stations, RefuseWrongArguments) {
  const Motion motion{0.1, {0, 1, 0}};
  const std::vector line{0.0, 1000.0};
  const auto refused = [&](const std::vector<double>& chainages, const NonUniform& excitation) {
    return complaint([&] { station_motions(motion, chainages, excitation); });
  };
  EXPECT_THAT(refused({}, {}), HasSubstr("there are no stations"));
  EXPECT_THAT(refused({0, kInfinity}, {}), HasSubstr("chainage of station 2 is inf"));
  EXPECT_THAT(refused(line, {.apparent_velocity = 0}), HasSubstr("apparent velocity is 0"));
  EXPECT_THAT(refused(line, {.apparent_velocity = 1e-9}), HasSubstr("give a larger apparent velocity"));
  EXPECT_THAT(refused(line, {.drift = -1}), HasSubstr("drift of the coherency is -1 s/m"));
}

}  // namespace
}  // namespace adit::motion::test::stations_test

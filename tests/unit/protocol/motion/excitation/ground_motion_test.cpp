// Requirements on how the scene's ground motion becomes the velocity of a base.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "protocol/motion/excitation/ground_motion.hpp"
#include "protocol/motion/fourier.hpp"
#include "protocol/motion/processing/processing.hpp"
#include "protocol/motion/velocity_history.hpp"
#include "protocol/scene/fields/check_rules.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/protocol/motion/support.hpp"

namespace adit::motion::test::ground_motion_test {
namespace {

using std::numbers::pi;
using testing::HasSubstr;

// The velocity between the values of the acceleration is the exact integral: of a straight line, a parabola.
TEST(VelocityHistory, IntegratesTheStraightLinesExactly) {
  const VelocityHistory velocity({0.5, {0, 1, -1}});
  EXPECT_EQ(velocity(-1), 0);
  EXPECT_DOUBLE_EQ(velocity(0.25), 0.0625);  // t^2
  EXPECT_DOUBLE_EQ(velocity(0.5), 0.25);
  EXPECT_DOUBLE_EQ(velocity(0.75), 0.375);  // the acceleration passes zero: the largest velocity
  EXPECT_DOUBLE_EQ(velocity(1), 0.25);
  EXPECT_DOUBLE_EQ(velocity(7), 0.25);
}

// A motion sampled at its natural step has the velocity of its formula to 1e-4 of the peak.
TEST(GroundMotion, NaturalStepIsFineEnough) {
  scene::GroundMotion scene;
  scene.mutable_ricker()->set_frequency(4);
  scene.mutable_ricker()->set_time(0.5);
  scene.set_baseline(false);
  const VelocityHistory velocity(ground_motion(scene, "motion", 1.0).acting());
  const double largest = std::exp(-0.5) / (pi * 4 * std::sqrt(2.0));
  for (double t = 0.001; t < 1; t += 0.0137) {
    const double x = pi * 4 * (t - 0.5);
    EXPECT_NEAR(velocity(t), x / (pi * 4) * std::exp(-x * x), 1e-4 * largest) << t;
  }
}

// Taper, then filter, then baseline, then scale: the field does what the functions do.
TEST(GroundMotion, IsPreparedInTheStatedOrder) {
  scene::GroundMotion scene;
  scene.mutable_gabor()->set_frequency(3);
  scene.mutable_gabor()->set_time(0.6);
  scene.set_taper(0.3);
  scene.set_peak(2);
  const Motion motion = ground_motion(scene, "motion", Sampling{.dt = 0.005, .duration = 2}).motion;
  const Sampling whole{.dt = 0.005, .duration = motion.duration()};
  const Motion expected =
      scaled_to_peak(baseline_corrected(tapered(gabor(1, 3, 4, 0, 0.6, whole), 0.3, 0.3)), 2);
  EXPECT_EQ(motion.acceleration, expected.acceleration);
}

// Share of the squared acceleration at frequencies from `first` to `last` [Hz].
double share_between(const Motion& motion, double first, double last) {
  const std::size_t n = 2 * ((motion.acceleration.size() + 1) / 2);
  const auto spectrum = transform(motion.acceleration, n);
  double inside = 0, all = 0;
  for (std::size_t j = 0; j < spectrum.size(); ++j) {
    const double frequency = static_cast<double>(j) / (static_cast<double>(n) * motion.dt);
    const double power = std::norm(spectrum[j]);
    all += power;
    if (frequency >= first && frequency <= last) inside += power;
  }
  return inside / all;
}

// A synthetic motion has periods from 0.1 s, or four of its steps, to 4 s where it is long enough for these.
TEST(GroundMotion, SyntheticHasTheStatedPeriods) {
  scene::GroundMotion scene;
  scene.mutable_synthetic()->set_corner_period(2);
  scene.set_peak(1);
  scene.set_baseline(false);
  const auto motion = [&](double dt, double duration) {
    scene.set_until(duration);
    return ground_motion(scene, "motion", Sampling{.dt = dt, .duration = duration}).motion;
  };
  EXPECT_LT(share_between(motion(0.01, 30), 0, 0.7 / 4), 0.002);
  EXPECT_GT(share_between(motion(0.01, 30), 0.9 / 4, 0.9 / 2), 0.01);
  // The fit to the spectrum widens the band a little at its upper end.
  const double high = share_between(motion(0.01, 30), 6, 10);
  EXPECT_GT(high, 3 * share_between(motion(0.01, 30), 11, 50));
  EXPECT_GT(high, 2 * share_between(motion(0.05, 30), 6, 10));
}

// A record keeps its own step and all of its values for a solver that needs no other step.
TEST(GroundMotion, RecordKeepsItsStepAndItsEnd) {
  scene::GroundMotion scene;
  scene.mutable_file()->set_path("a.csv");
  scene.mutable_file()->set_content("time_s,a_m/s^2\n0,0\n0.25,2\n0.5,-2\n0.75,0\n1,1\n1.25,0\n");
  scene.set_baseline(false);
  const Motion motion = ground_motion(scene, "motion", 1.0).motion;
  EXPECT_EQ(motion.dt, 0.25);
  EXPECT_THAT(motion.acceleration, testing::ElementsAre(0, 2, -2, 0, 1, 0));
}

// What the record's text refuses is an error of the field that names the file.
TEST(GroundMotion, RecordsErrorsNameTheField) {
  scene::GroundMotion scene;
  scene.mutable_file()->set_path("wrong.csv");
  scene.mutable_file()->set_content("time_s,acceleration_kg\n0,0\n1,1\n");
  adit::test::expect_refusal([&] { ground_motion(scene, "motion", 1.0); }, "motion.file.path",
                             "wrong.csv:1: ");
}

// Corners that let nothing pass.
TEST(GroundMotion, RefusesExchangedCorners) {
  scene::GroundMotion scene;
  scene.mutable_ricker()->set_frequency(5);
  scene.mutable_ricker()->set_time(0.5);
  scene.set_low_corner(20);
  scene.set_high_corner(2);
  adit::test::expect_refusal([&] { protocol::check_rules(scene, "motion"); }, "motion.high_corner",
                             "is 2 Hz, expected a frequency above `low_corner` = 20 Hz");
}

}  // namespace
}  // namespace adit::motion::test::ground_motion_test

// Requirements on motions of which a run uses a part: the part is that of the motion processed as a whole,
// whatever the duration of the run, and the user hears where it is cut inside shaking.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "protocol/motion/excitation/ground_motion.hpp"
#include "protocol/motion/excitation/stations.hpp"
#include "protocol/motion/measures.hpp"
#include "protocol/motion/processing/part.hpp"
#include "protocol/motion/processing/processing.hpp"
#include "protocol/motion/velocity_history.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/protocol/motion/support.hpp"

namespace adit::motion::test::cut_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kStep = 0.01, kLength = 60, kStrong = 12;

// Shaking of 2 Hz around kStrong, on a long wave of 0.05 Hz that lasts to the end, as a record: what a
// correction of the cut motion would take for a wrong baseline.
double shaking(double t) {
  const double far = (t - kStrong) / 2;
  return 3 * std::exp(-far * far) * std::sin(2 * kPi * 2 * t) + 0.004 * std::sin(2 * kPi * 0.05 * t);
}

scene::GroundMotion record() {
  scene::GroundMotion scene;
  std::string text = "time_s,a_m/s^2\n";
  for (int i = 0; i <= kLength / kStep; ++i)
    text += fmt::format("{:.2f},{:.17g}\n", i * kStep, shaking(i * kStep));
  scene.mutable_file()->set_path("record.csv");
  scene.mutable_file()->set_content(text);
  return scene;
}

// The record itself, processed as a whole.
Motion whole(const scene::GroundMotion& scene) {
  return ground_motion(scene, "motion", kLength).motion;
}

// PGV, PGD and Arias intensity of a run that ends after the strong part are those of the record.
TEST(CutMotion, HasTheMeasuresOfTheRecord) {
  const Motion full = beginning(whole(record()), 40);
  for (const double duration : {18.0, 25.0, 40.0}) {
    const Motion cut = beginning(ground_motion(record(), "motion", duration).motion, duration);
    EXPECT_EQ(cut.acceleration.size(), std::round(duration / kStep) + 1);
    EXPECT_DOUBLE_EQ(peaks(cut).acceleration, peaks(full).acceleration);
    EXPECT_DOUBLE_EQ(peaks(cut).velocity, peaks(full).velocity);
    EXPECT_NEAR(arias_intensity(cut), arias_intensity(full), 1e-4 * arias_intensity(full));
  }
  EXPECT_DOUBLE_EQ(peaks(beginning(ground_motion(record(), "motion", 25).motion, 25)).displacement,
                   peaks(beginning(whole(record()), 25)).displacement);
}

using Give = std::function<void(scene::GroundMotion&)>;

// Every source of a motion.
const std::vector<std::pair<const char*, Give>>& sources() {
  static const std::vector<std::pair<const char*, Give>> all{
      {"file", [](scene::GroundMotion& motion) { motion.MergeFrom(record()); }},
      {"ricker",
       [](scene::GroundMotion& motion) {
         motion.mutable_ricker()->set_frequency(2);
         motion.mutable_ricker()->set_time(1);
       }},
      {"sine",
       [](scene::GroundMotion& motion) {
         motion.mutable_sine()->set_frequency(2);
         motion.mutable_sine()->set_end(2.63);
       }},
      {"gabor",
       [](scene::GroundMotion& motion) {
         motion.mutable_gabor()->set_frequency(2);
         motion.mutable_gabor()->set_time(1.5);
       }},
      {"synthetic", [](scene::GroundMotion& motion) { motion.mutable_synthetic()->set_seed(3); }}};
  return all;
}

// Every way to change it.
const std::vector<std::pair<const char*, Give>>& changes() {
  static const std::vector<std::pair<const char*, Give>> all{
      {"as it is", [](scene::GroundMotion& /*motion*/) {}},
      {"without baseline", [](scene::GroundMotion& motion) { motion.set_baseline(false); }},
      {"filtered",
       [](scene::GroundMotion& motion) {
         motion.set_low_corner(0.3);
         motion.set_high_corner(20);
       }},
      {"tapered and scaled",
       [](scene::GroundMotion& motion) {
         motion.set_taper(0.2);
         motion.set_peak(2);
       }},
      {"a part", [](scene::GroundMotion& motion) {
         motion.set_from(0.5);
         motion.set_until(2.2);
       }}};
  return all;
}

scene::GroundMotion changed(const Give& give, const Give& change) {
  scene::GroundMotion scene;
  give(scene);
  change(scene);
  return scene;
}

// A motion is a function of time alone: the run of any duration has the beginning of the longest, to the bit,
// and half a step of its solver farther.
TEST(CutMotion, DoesNotDependOnTheDuration) {
  for (const auto& [source, give] : sources())
    for (const auto& [change, modify] : changes()) {
      const scene::GroundMotion scene = changed(give, modify);
      const VelocityHistory longest(ground_motion(scene, "motion", 45).acting());
      for (const double duration : {0.02, 1.9, 4.0}) {
        const VelocityHistory velocity(ground_motion(scene, "motion", duration).acting());
        for (double t = 0; t <= 1.1 * duration; t += duration / 13)
          EXPECT_EQ(velocity(t), longest(t)) << source << ' ' << change << ' ' << duration << ' ' << t;
      }
    }
}

// The same at a place that the wave reaches with a delay and a loss of coherency, after the end of the
// motion, too.
TEST(CutMotion, DoesNotDependOnTheDurationAtOtherPlaces) {
  for (const char* wanted : {"sine", "gabor"})
    for (const auto& [source, give] : sources()) {
      if (source != std::string(wanted)) continue;
      scene::GroundMotion scene = changed(give, changes()[0].second);
      scene.set_until(2);
      const auto at = [&](double duration) {
        const UsedMotion used = ground_motion(scene, "motion", duration);
        const NonUniform wave{.apparent_velocity = 800, .drift = 2e-4, .seed = 1};
        return VelocityHistory(used.acting(station_motions(used.motion, std::vector{0.0, 130.0}, wave)[1]));
      };
      const VelocityHistory longer = at(9), shorter = at(4);
      for (double t = 0; t <= 4; t += 0.0371) EXPECT_EQ(shorter(t), longer(t)) << source << ' ' << t;
    }
}

// The same for a solver that takes motions at its own step.
TEST(CutMotion, DoesNotDependOnTheDurationAtAGivenStep) {
  for (const auto& [source, give] : sources())
    for (const auto& [change, modify] : changes()) {
      const scene::GroundMotion scene = changed(give, modify);
      const auto at = [&](double duration) {
        return lasting(ground_motion(scene, "motion", Sampling{0.008, duration}).motion, duration)
            .acceleration;
      };
      const auto longest = at(45);
      const auto beginning = at(4);
      for (std::size_t i = 0; i < beginning.size(); ++i)
        ASSERT_EQ(beginning[i], longest[i]) << source << ' ' << change << ' ' << i;
    }
}

// After its end the ground stays where a correction of the baseline led it: at rest.
TEST(CutMotion, RestsAfterItsEnd) {
  for (const auto& [source, give] : sources()) {
    scene::GroundMotion scene;
    give(scene);
    scene.set_peak(1);
    EXPECT_NEAR(VelocityHistory(ground_motion(scene, "motion", 60).acting())(60), 0, 1e-6) << source;
  }
}

// A run that begins inside the record starts from rest. After a second it has the acceleration and velocity
// of the record, and the displacement grows with that of the record.
TEST(CutMotion, IsThatOfTheRecordASecondAfterItsBegin) {
  scene::GroundMotion scene = record();
  scene.set_from(8);
  const Motion full = whole(record()), used = ground_motion(scene, "motion", 20).motion;
  const Course before = integrate(full), after = integrate(used);
  EXPECT_EQ(used.acceleration[0], 0);
  EXPECT_GT(std::abs(before.velocity[800]), 0.01);
  const double moved = after.displacement[100] - before.displacement[900];
  for (std::size_t i = 100; i < used.acceleration.size(); ++i) {
    EXPECT_NEAR(used.acceleration[i], full.acceleration[i + 800], 1e-12);
    EXPECT_NEAR(after.velocity[i], before.velocity[i + 800], 1e-12);
    EXPECT_NEAR(after.displacement[i] - before.displacement[i + 800], moved, 1e-10);
  }
}

// Displacement counts on from where the ground lies at `from`, so that the peaks of a run that begins before
// the strong part are those of the record.
TEST(CutMotion, HasTheMeasuresOfTheRecordWhereItBeginsInside) {
  const Motion full = beginning(whole(record()), 25);
  scene::GroundMotion scene = record();
  EXPECT_EQ(ground_motion(scene, "motion", 20).place, 0);
  for (const double from : {2.0, 5.0, 8.0}) {
    scene.set_from(from);
    const UsedMotion used = ground_motion(scene, "motion", 25 - from);
    const Motion cut = beginning(used.motion, 25 - from);
    EXPECT_GT(std::abs(used.place), 1e-3);
    EXPECT_NEAR(peaks(cut, used.place).velocity, peaks(full).velocity, 1e-12);
    EXPECT_NEAR(peaks(cut, used.place).displacement, peaks(full).displacement, 1e-10);
    EXPECT_GT(std::abs(peaks(cut).displacement - peaks(full).displacement), 1e-3);
    EXPECT_NEAR(arias_intensity(cut), arias_intensity(full), 1e-3 * arias_intensity(full));
  }
}

// The closed form of the window on a ground that moves with a constant velocity: w v rises to it within a
// second, and covers half of its way.
TEST(CutMotion, LeadsTheVelocityInByHalfACosine) {
  Motion steady{0.01, std::vector<double>(1000, 0)};
  for (std::size_t i = 0; i < 100; ++i) steady.acceleration[i] = 0.2;
  const double v = integrate(steady).velocity.back();
  const Motion used = part(steady, 5, std::numeric_limits<double>::infinity());
  const Course course = integrate(used);
  for (std::size_t i = 0; i <= 100; ++i) {
    const double s = static_cast<double>(i) / 100;
    EXPECT_NEAR(course.velocity[i], v * (1 - std::cos(kPi * s)) / 2, 1e-4 * v);
  }
  EXPECT_NEAR(course.displacement[100], v / 2, 1e-4 * v);
  EXPECT_NEAR(added_by_window(steady, 5, std::numeric_limits<double>::infinity()), kPi / 2 * v, 1e-3 * v);
}

// After `until` the ground rests.
TEST(CutMotion, EndsAtRest) {
  scene::GroundMotion scene = record();
  scene.set_from(5);
  scene.set_until(17);
  const UsedMotion used = ground_motion(scene, "motion", 30);
  const Course course = integrate(used.motion);
  EXPECT_NEAR(used.motion.acceleration.back(), 0, 1e-12);
  const VelocityHistory velocity(used.acting());
  EXPECT_EQ(course.velocity.size(), 1201U);
  EXPECT_NEAR(course.velocity.back(), 0, 1e-12);
  EXPECT_NEAR(velocity(25), 0, 1e-6 * peaks(used.motion).velocity);
}

// A window on the acceleration alone would leave the velocity of the record at `from` behind.
TEST(CutMotion, DoesNotDriftAfterItsBegin) {
  scene::GroundMotion scene = record();
  scene.set_from(11.1);
  EXPECT_NEAR(integrate(ground_motion(scene, "motion", 40).motion).velocity.back(), 0, 1e-12);
}

TEST(CutMotion, TellsWhatIsLeftOut) {
  EXPECT_THAT(ground_motion(record(), "motion", 40).notes, IsEmpty());
  scene::GroundMotion scene = record();
  auto notes = ground_motion(scene, "motion", kStrong).notes;
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_THAT(notes[0], HasSubstr("is used up to 12 s, inside its shaking: 50.0 % of its Arias intensity"));
  EXPECT_THAT(notes[0], HasSubstr("lengthen time.duration"));
  scene.set_until(11);
  EXPECT_THAT(ground_motion(scene, "motion", 20).notes, testing::Contains(HasSubstr("end later")));
  scene.clear_until();
  scene.set_from(12);
  notes = ground_motion(scene, "motion", 20).notes;
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_THAT(notes[0], HasSubstr("is used from 12 s on, inside its shaking: 50.0 % of its Arias intensity"));
  EXPECT_THAT(notes[1], HasSubstr("raises its acceleration there by up to"));
}

// A synthetic motion has an end of its own, and the user hears where it is short of periods or of time.
TEST(CutMotion, OfASyntheticOneTellsItsEnd) {
  scene::GroundMotion scene;
  scene.mutable_synthetic()->set_seed(5);
  EXPECT_THAT(ground_motion(scene, "motion", 20).notes, IsEmpty());
  EXPECT_THAT(ground_motion(scene, "motion", 25).notes,
              testing::ElementsAre(HasSubstr("lasts 20 s, and the ground rests afterwards; give `until`")));
  scene.set_until(2);
  EXPECT_THAT(ground_motion(scene, "motion", 2).notes,
              testing::ElementsAre(HasSubstr("of 2 s has periods up to 0.667 s instead of 4 s")));
}

// A sine of n periods from rest moves away by n of its periods times the mean velocity A / w: 2 pi n times
// its amplitude A / w^2. The user hears that, and does not where a taper lets it swing about its place.
TEST(CutMotion, TellsHowFarASineDrifts) {
  scene::GroundMotion scene;
  scene.mutable_sine()->set_frequency(1);
  scene.mutable_sine()->set_end(8);
  scene.set_baseline(false);
  const auto notes = ground_motion(scene, "motion", 8).notes;
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_THAT(notes[0], HasSubstr("by up to 1.27 m, 50.3 times the amplitude of 0.0253 m"));
  scene.set_taper(3);
  EXPECT_THAT(ground_motion(scene, "motion", 8).notes, IsEmpty());
}

// `peak` is that of the curve that drives the model, whose largest value may lie between those of a record.
TEST(CutMotion, HasTheStatedPeakBetweenTheValuesOfARecord) {
  scene::GroundMotion scene;
  std::string text = "time_s,a_m/s^2\n";
  for (int i = 0; i <= 400; ++i) {
    const double t = i * 0.02, far = (t - 4.01) / 0.1;
    text += fmt::format("{:.2f},{:.17g}\n", t, std::exp(-far * far) * std::cos(2 * kPi * 14 * (t - 4.01)));
  }
  scene.mutable_file()->set_path("record.csv");
  scene.mutable_file()->set_content(text);
  scene.set_peak(2);
  for (const bool baseline : {false, true}) {
    scene.set_baseline(baseline);
    const UsedMotion used = ground_motion(scene, "motion", 8);
    EXPECT_NEAR(peaks(used.acting()).acceleration, 2, 1e-3);
    EXPECT_LT(peaks(used.motion).acceleration, 1.7);
    EXPECT_THAT(used.notes, IsEmpty());
    for (const double dt : {0.02, 0.01, 0.003})
      EXPECT_NEAR(peaks(ground_motion(scene, "motion", Sampling{dt, 8}).motion).acceleration, 2, 1e-3) << dt;
  }
  const UsedMotion part = ground_motion(scene, "motion", 3.5);
  EXPECT_LT(part.peak, 0.1);
  EXPECT_THAT(*note_on_peak(scene, part),
              HasSubstr("m/s^2 instead of `peak` = 2 m/s^2, because the run takes a part"));
  EXPECT_FALSE(note_on_peak(scene, ground_motion(scene, "motion", 8)));
}

// A wavelet whose middle lies too early begins at once, here with |1 - 2 s| exp(-s), s = (pi 3 Hz 0.1 s)^2.
TEST(CutMotion, TellsWhereAMotionBeginsAtOnce) {
  scene::GroundMotion scene;
  scene.mutable_ricker()->set_frequency(3);
  scene.mutable_ricker()->set_time(0.1);
  scene.set_baseline(false);
  EXPECT_THAT(ground_motion(scene, "motion", 2).notes,
              testing::Contains(HasSubstr("begins at once with 0.32 m/s^2, 32 % of its peak")));
  scene.mutable_ricker()->set_time(0.5);
  EXPECT_THAT(ground_motion(scene, "motion", 2).notes, IsEmpty());
}

TEST(CutMotion, RefusesAPartThatIsNotThere) {
  scene::GroundMotion scene = record();
  const auto refuses = [&](double duration, const std::string& path, const std::string& text) {
    adit::test::expect_refusal([&] { ground_motion(scene, "motion", duration); }, path, text);
  };
  refuses(61, "motion.file.path",
          "lasts 60 s, but 61 s are asked for; ask for less, or give `until: 60 s`, after which the ground "
          "rests");
  scene.set_from(50);
  refuses(11, "motion.file.path", "lasts 60 s, but 61 s are asked for");
  scene.set_until(70);
  refuses(5, "motion.file.path", "lasts 60 s, but 70 s are asked for");
  scene.set_until(50.1);
  refuses(5, "motion", "has 11 values, too few to begin and end at rest; give at least 17");
  scene.Clear();
  scene.mutable_ricker()->set_frequency(2);
  scene.mutable_ricker()->set_time(1);
  scene.set_until(1.01);
  scene.set_from(1);
  refuses(5, "motion", "too few to begin and end at rest");
}

}  // namespace
}  // namespace adit::motion::test::cut_test

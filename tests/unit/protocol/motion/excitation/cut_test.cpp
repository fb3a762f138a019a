// Requirements on motions of which a run uses a part: the part is that of the motion processed as a whole,
// whatever the duration of the run, and the user hears where it is cut inside shaking.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>

#include "protocol/motion/excitation/ground_motion.hpp"
#include "protocol/motion/measures.hpp"
#include "protocol/motion/processing/part.hpp"
#include "protocol/motion/processing/processing.hpp"
#include "protocol/motion/velocity_history.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/protocol/motion/support.hpp"

namespace adit::motion::test {
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

// Filters, baseline and scale belong to the whole motion: a shorter run is the beginning of a longer one, as
// long as the motion outlasts both.
TEST(CutMotion, DoesNotDependOnTheDuration) {
  const auto ricker = [](scene::GroundMotion& motion) {
    motion.mutable_ricker()->set_frequency(2);
    motion.mutable_ricker()->set_time(1);
  };
  const auto gabor = [](scene::GroundMotion& motion) {
    motion.mutable_gabor()->set_frequency(2);
    motion.mutable_gabor()->set_time(1.5);
  };
  const auto sine = [](scene::GroundMotion& motion) {
    motion.mutable_sine()->set_frequency(2);
    motion.mutable_sine()->set_end(3);
  };
  const auto synthetic = [](scene::GroundMotion& motion) {
    motion.mutable_synthetic()->set_seed(3);
    motion.set_until(20);
  };
  const auto file = [](scene::GroundMotion& motion) { motion = record(); };
  for (const std::function<void(scene::GroundMotion&)>& give :
       std::initializer_list<std::function<void(scene::GroundMotion&)>>{ricker, gabor, sine, synthetic,
                                                                        file}) {
    scene::GroundMotion scene;
    give(scene);
    scene.set_low_corner(0.1);
    scene.set_taper(0.2);
    scene.set_peak(2);
    const VelocityHistory longer(ground_motion(scene, "motion", 1.5).acting());
    for (const double duration : {0.02, 0.7}) {
      const VelocityHistory velocity(ground_motion(scene, "motion", duration).acting());
      for (double t = 0; t <= duration; t += duration / 7)
        EXPECT_EQ(velocity(t), longer(t)) << scene.source_case() << ' ' << duration << ' ' << t;
    }
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
  EXPECT_GE(used.motion.duration(), 30);
  const Course course = integrate(used.motion);
  EXPECT_NEAR(used.motion.acceleration[1200], 0, 1e-12);
  const VelocityHistory velocity(used.acting());
  for (std::size_t i = 1200; i < course.velocity.size(); ++i) {
    EXPECT_NEAR(course.velocity[i], 0, 1e-12);
    EXPECT_NEAR(course.displacement[i], course.displacement[1200], 1e-10);
  }
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

// A trial run of a synthetic motion is its beginning where `until` says how long the whole one is, or where
// the run is too short for any; else it is another motion, and the user hears that.
TEST(CutMotion, OfASyntheticOneIsATrial) {
  scene::GroundMotion scene;
  scene.mutable_synthetic()->set_seed(5);
  scene.set_peak(2);
  EXPECT_THAT(ground_motion(scene, "motion", 20).notes, IsEmpty());
  EXPECT_THAT(ground_motion(scene, "motion", 2).notes,
              testing::ElementsAre(HasSubstr("its longest period is 0.667 s instead of 4 s")));
  const UsedMotion shortest = ground_motion(scene, "motion", 0.2);
  EXPECT_THAT(shortest.notes, testing::Contains(HasSubstr("gets the beginning of one of 12 s")));
  scene.set_until(12);
  const UsedMotion trial = ground_motion(scene, "motion", 0.2);
  EXPECT_THAT(trial.notes, testing::Contains(HasSubstr("inside its shaking")));
  const auto a = beginning(shortest.motion, 0.2).acceleration, b = beginning(trial.motion, 0.2).acceleration,
             c = beginning(ground_motion(scene, "motion", 12).motion, 0.2).acceleration;
  EXPECT_EQ(a, b);
  EXPECT_EQ(b, c);
}

TEST(CutMotion, RefusesAPartThatIsNotThere) {
  scene::GroundMotion scene = record();
  const auto refuses = [&](double duration, const std::string& path, const std::string& text) {
    adit::test::expect_refusal([&] { ground_motion(scene, "motion", duration); }, path, text);
  };
  refuses(61, "motion.file.path", "lasts 60 s, but 61 s are asked for");
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
}  // namespace adit::motion::test

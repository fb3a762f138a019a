// Requirements on the way from the scene's earthquake to the velocity of a base.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "protocol/errors.hpp"
#include "protocol/motion/ground_motion.hpp"
#include "protocol/motion/processing.hpp"
#include "protocol/motion/records_of_scene.hpp"
#include "protocol/motion/velocity_history.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/motion/support.hpp"

namespace adit::motion::test {
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
  const VelocityHistory velocity(ground_motion(scene, "motion", 1.0));
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
  const Sampling sampling{.dt = 0.005, .duration = 2};
  const Motion expected =
      scaled_to_peak(baseline_corrected(tapered(gabor(1, 3, 4, 0, 0.6, sampling), 0.3, 0.3)), 2);
  EXPECT_EQ(ground_motion(scene, "motion", sampling).acceleration, expected.acceleration);
}

// A record keeps its own step for a solver that needs no other.
TEST(GroundMotion, RecordKeepsItsStep) {
  scene::GroundMotion scene;
  scene.mutable_file()->set_path("a.csv");
  scene.mutable_file()->set_step(0.25);
  for (const double a : {0, 2, -2, 0, 1, 0}) scene.mutable_file()->add_acceleration(a);
  scene.set_baseline(false);
  const Motion motion = ground_motion(scene, "motion", 1.0);
  EXPECT_EQ(motion.dt, 0.25);
  EXPECT_THAT(motion.acceleration, testing::ElementsAre(0, 2, -2, 0, 1));
}

// Every file of a scene is read once, from the folder of the file that names it; then the scene needs no
// file.
TEST(RecordsOfScene, ComeFromTheFolderOfTheFileThatNamesThem) {
  const adit::test::ScratchFolder folder;
  std::filesystem::create_directory(folder / "bases");
  folder.write("bases/record.csv", "time_ms,acceleration_gal\n0,0\n10,100\n20,-100\n");
  folder.write("bases/base.yaml", R"(
time: {duration: 20 ms}
regions:
  - name: ground
    continuum:
      block: {x_min: 0 m, x_max: 1 m, y_min: 0 m, y_max: 1 m, zones_x: 1, zones_y: 1}
      base: {acceleration: {file: {path: record.csv}}}
)");
  auto file = protocol::read_scene(folder.write("scene.yaml", "base: bases/base.yaml\n"));
  read_records(file);
  const auto& record = file.scene.regions(0).continuum().base().acceleration().file();
  EXPECT_DOUBLE_EQ(record.step(), 0.01);
  EXPECT_THAT(record.acceleration(), testing::ElementsAre(0, 1, -1));
  std::filesystem::remove(folder / "bases" / "record.csv");
  read_records(file);
  EXPECT_EQ(record.acceleration_size(), 3);
}

// A file that cannot be read is an error of the field that names it.
TEST(RecordsOfScene, ErrorsNameTheField) {
  const adit::test::ScratchFolder folder;
  folder.write("wrong.csv", "time_s,acceleration_kg\n0,0\n1,1\n");
  auto file = protocol::read_scene(folder.write("scene.yaml", R"(
time: {duration: 1 s}
continuum:
  block: {x_min: 0 m, x_max: 1 m, y_min: 0 m, y_max: 1 m, zones_x: 1, zones_y: 1}
  base: {acceleration: {file: {path: wrong.csv}}}
)"));
  try {
    read_records(file);
    FAIL() << "no error";
  } catch (const protocol::UserError& error) {
    EXPECT_EQ(error.path(), "continuum.base.acceleration.file.path");
    EXPECT_THAT(error.what(), HasSubstr("wrong.csv:1: "));
  }
}

}  // namespace
}  // namespace adit::motion::test

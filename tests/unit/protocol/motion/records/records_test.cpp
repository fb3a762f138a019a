// Requirements on measured records, which are not part of the repository.
#include <gmock/gmock.h>

#include <fstream>
#include <iterator>

#include "protocol/motion/excitation/ground_motion.hpp"
#include "protocol/motion/measures.hpp"
#include "protocol/motion/processing/processing.hpp"
#include "protocol/motion/records/records.hpp"
#include "tests/support/read_motion.hpp"
#include "tests/unit/protocol/motion/support.hpp"

namespace adit::motion::test::records_test {
namespace {

using adit::test::read_motion;
using testing::HasSubstr;

const std::filesystem::path kRecords = ADIT_RECORDS;

struct Known {
  const char* file;
  std::size_t count;
  double dt, pga;  // [s], [g]
};

// Count, step and peak are those known of each record.
TEST(Records, AreReadAsKnown) {
  for (const auto& known :
       {Known{"NIS090.AT2", 4096, 0.01, 0.502749}, Known{"RSN1106_KOBE_KJM000.AT2", 7500, 0.02, 0.8342289},
        Known{"RSN4346_UBMARCHE.P_A-BEV000.AT2", 10102, 0.005, 0.07854513}}) {
    const Motion motion = read_motion(kRecords / known.file);
    EXPECT_EQ(motion.acceleration.size(), known.count);
    EXPECT_EQ(motion.dt, known.dt);
    EXPECT_NEAR(peaks(motion).acceleration, known.pga * 9.80665, 1e-9);
  }
}

// The record whose header belongs to another is refused: both counts, and the doubt about its unit.
TEST(Records, RefuseTheWrongHeaderWithBothCounts) {
  EXPECT_THAT(complaint([] { read_motion(kRecords / "KOBE_NS1_wrong_header.AT2"); }),
              AllOf(HasSubstr("KOBE_NS1_wrong_header.AT2:4: states 10102 points, but 2567 values follow"),
                    HasSubstr("the largest value is 818 G")));
}

// A measured motion drifts when integrated; after the correction it ends at rest and in its place, and its
// peak has changed by less than 2 %.
TEST(Records, EndAtRestAfterBaselineCorrection) {
  const Motion motion = read_motion(kRecords / "NIS090.AT2");
  const Motion corrected = baseline_corrected(motion);
  const Course course = integrate(corrected);
  EXPECT_NEAR(course.velocity.back(), 0, 1e-10);
  EXPECT_NEAR(course.displacement.back(), 0, 1e-9);
  EXPECT_NEAR(peaks(corrected).acceleration / peaks(motion).acceleration, 1, 0.02);
}

// A run of 18 s of the record has its PGV and PGD, and its Arias intensity but for what the coda adds. So has
// one that begins at 4 s, where the ground lies 6 mm away from its place. At 0.3 g, integrated without any
// correction, the record has 0.330 m/s and 0.076 m.
TEST(Records, KeepTheirMeasuresInAShorterRun) {
  scene::GroundMotion scene;
  const auto path = kRecords / "RSN1106_KOBE_KJM000.AT2";
  scene.mutable_file()->set_path(path);
  std::ifstream file(path);
  scene.mutable_file()->set_content({std::istreambuf_iterator<char>(file), {}});
  scene.set_peak(0.3 * 9.80665);
  const Motion whole = ground_motion(scene, "motion", 149).motion;
  // As published for values of at most 0.3 g; the curve between the values, which has the stated peak, rises
  // above them.
  const double below_peak = peaks(whole).acceleration / scene.peak();
  EXPECT_NEAR(peaks(whole).velocity / below_peak, 0.330, 0.003);
  EXPECT_NEAR(peaks(whole).displacement / below_peak, 0.076, 0.001);
  for (const double from : {0.0, 4.0}) {
    scene.set_from(from);
    const UsedMotion used = ground_motion(scene, "motion", 18 - from);
    const Motion cut = beginning(used.motion, 18 - from);
    EXPECT_THAT(used.notes, testing::SizeIs(testing::Ge(1)));
    EXPECT_NEAR(peaks(cut).velocity, peaks(whole).velocity, 1e-9);
    EXPECT_NEAR(peaks(cut, used.place).displacement, peaks(whole).displacement, 1e-9);
    EXPECT_NEAR(std::abs(used.place), from == 0 ? 0 : 0.006, 0.0005);
    EXPECT_NEAR(arias_intensity(cut) / arias_intensity(whole), 0.98, 0.02);
    const Peaks acting = peaks(used.acting());
    EXPECT_NEAR(acting.velocity / peaks(cut).velocity, 1, 0.01);
    EXPECT_NEAR(acting.displacement / peaks(cut).displacement, 1, 0.002);
  }
}

}  // namespace
}  // namespace adit::motion::test::records_test

// Requirements on measured records, which are not part of the repository.
#include <gmock/gmock.h>

#include "protocol/motion/measures.hpp"
#include "protocol/motion/processing/processing.hpp"
#include "protocol/motion/records/records.hpp"
#include "tests/unit/protocol/motion/support.hpp"

namespace adit::motion::test {
namespace {

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

}  // namespace
}  // namespace adit::motion::test

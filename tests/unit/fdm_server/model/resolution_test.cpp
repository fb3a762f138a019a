// Requirement: the user hears that zones are too large for the frequencies of the earthquake, and of which
// material.
#include "fdm_server/model/resolution.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/fdm_server/boundaries/boundary_scenes.hpp"

namespace adit::fdm::test::resolution_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

const std::string kBlock = "block { x_min: 0 x_max: 4 y_min: -3 y_max: 0 zones_x: 4 zones_y: 3 } ";
// 50 m/s, for the lowest zones.
const std::string kSoft =
    "materials { where { y_max: -2 } material { young_modulus: 1.25e7 poisson_ratio: 0.25 density: 2000 } } ";

std::string shaken(const std::string& motion) {
  return "base { kind: COMPLIANT acceleration { " + motion + " } } ";
}

std::vector<std::string> notes(const std::string& continuum, double duration) {
  const GroundRun run(continuum, duration);
  return {run.model.notes().begin(), run.model.notes().end()};
}

// Ten zones of 1 m in a wave of 200 or 50 m/s.
TEST(Resolution, IsTenZonesInTheShortestWave) {
  EXPECT_DOUBLE_EQ(GroundRun(kBlock, 1).model.highest_frequency(), 20);
  EXPECT_DOUBLE_EQ(GroundRun(kBlock + kSoft, 1).model.highest_frequency(), 5);
}

// Nothing varies across a column of one zone, however wide it is.
TEST(Resolution, OfAColumnIsThatOfItsHeight) {
  const GroundRun run("block { x_min: 0 x_max: 9 y_min: -3 y_max: 0 zones_x: 1 zones_y: 6 }", 1);
  EXPECT_DOUBLE_EQ(run.model.highest_frequency(), 40);
}

TEST(Resolution, IsComparedWithTheMotion) {
  EXPECT_THAT(notes(kBlock + shaken("ricker { frequency: 5 time: 0.4 }"), 1), IsEmpty());
  EXPECT_THAT(notes(kBlock + kSoft, 1), IsEmpty());
  const auto found = notes(kBlock + kSoft + shaken("ricker { frequency: 5 time: 0.4 }"), 1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0],
              HasSubstr("zones of `materials[0]` (c_s 50 m/s, sides up to 1 m) carry shear waves well up to "
                        "5 Hz, with 10 zones a wavelength, but 99 % of the motion's energy"));
}

TEST(Resolution, IsComparedWithTheCornerThatTheUserGives) {
  const auto found = notes(kBlock + shaken("ricker { frequency: 5 time: 0.4 } high_corner: 40"), 1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0], HasSubstr("zones of `material` (c_s 200 m/s"));
  EXPECT_THAT(
      found[0],
      HasSubstr(
          "`high_corner` lets the motion pass up to 40 Hz, where there are 5; make them at most 0.5 m"));
}

// The participant passes on what the motion leaves out.
TEST(Resolution, StandsBesideTheNotesOnTheCut) {
  const auto found = notes(kBlock + shaken("ricker { frequency: 5 time: 0.4 }"), 0.4);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0],
              HasSubstr("base.acceleration: the motion is used up to 0.4 s, inside its shaking: 50"));
}

}  // namespace
}  // namespace adit::fdm::test::resolution_test

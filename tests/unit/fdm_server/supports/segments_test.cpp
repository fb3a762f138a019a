// Requirements on joints of segments as scenes state them: they are read with their defaults, and what does
// not fit is refused in one sentence.
#include "fdm_server/model/supports/segments.hpp"

#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include "tests/support/refusals.hpp"

namespace adit::fdm::test::segments_test {
namespace {

const std::string kContact = "contact { height: 0.2 } ";
const std::string kCurve = "force { opening: [-1e-3, 0, 4e-3] force: [-60e3, -20e3, 0] } ";

std::shared_ptr<const JointLaw> segments(const std::string& joint,
                                         const std::string& more = "thickness: 0.35 ", double share = 1) {
  scene::Lining lining;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(
      more + "young_modulus: 35e9 joints { " + joint + "}", &lining));
  return read_segments(lining, lining.joints(0), nullptr, share, "joint");
}

// The faces have the modulus of the lining, bolts are per metre, and openings are told at the lining's faces.
TEST(Segments, AreReadWithTheirDefaults) {
  EXPECT_EQ(segments("rotational_stiffness: 1e7 "), nullptr);
  const auto law = segments(kContact + "bolts { stiffness: 60e6 pretension: 90e3 spacing: 1.5 } ");
  EXPECT_EQ(law->faces.height, 0.2);
  EXPECT_EQ(law->faces.young, 35e9);
  EXPECT_EQ(law->edge, 0.175);
  EXPECT_EQ(law->bolts[0].stiffness, 40e6);
  EXPECT_EQ(law->bolts[0].pretension, 60e3);
  EXPECT_EQ(segments("contact { height: 0.2 young_modulus: 30e9 } ")->faces.young, 30e9);
  // A rectangle of the same area and inertia.
  EXPECT_NEAR(segments(kContact, "area: 0.3 inertia: 2.25e-3 ")->edge, 0.15, 1e-12);
}

// All that a joint does is in proportion to its share of the plane.
TEST(Segments, HaveTheirShareOfThePlane) {
  const std::string joint = kContact + "bolts { stiffness: 60e6 pretension: 30e3 spacing: 1.5 } gasket { " +
                            "position: 0.1 width: 0.03 water_pressure: 1e5 " + kCurve + "} ";
  const std::string lining = "thickness: 0.35 ";
  const auto whole = segments(joint, lining), half = segments(joint, lining, 0.5);
  const JointOpening opening{1e-4, 2e-3};
  const std::vector<double> slack{0};
  EXPECT_LE((half->forces(opening, slack) - whole->forces(opening, slack) / 2).norm(),
            1e-12 * whole->forces(opening, slack).norm());
  EXPECT_EQ(half->gasket->water_force, whole->gasket->water_force / 2);
}

// A gasket presses beyond its curve with the first slope, and does not pull where it let go.
TEST(Segments, AGasketDoesNotPull) {
  const auto law = segments(kContact + "gasket { position: 0.1 " + kCurve + "} ");
  EXPECT_NEAR(law->gasket->force.force(-2e-3), -100e3, 1e-6);
  EXPECT_EQ(law->gasket->force.force(5e-3), 0);
}

struct Case {
  std::string name, joint, path, message;
};
void PrintTo(const Case& refused, std::ostream* out) {
  *out << refused.name;
}

class SegmentsError : public testing::TestWithParam<Case> {};

TEST_P(SegmentsError, NamesTheFieldAndTheRemedy) {
  adit::test::expect_refusal([] { segments(GetParam().joint); }, GetParam().path, GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, SegmentsError,
    testing::Values(
        Case{"higher_than_thick", "contact { height: 0.4 } ", "joint.contact.height",
             "is 0.4 m, more than the lining's thickness of 0.35 m; give at most that"},
        Case{
            "spring_beside", kContact + "rotational_stiffness: 1e7 ", "joint",
            "is both the faces of segments (`contact`) and a spring (`rotational_stiffness`); leave one out"},
        Case{"bolts_alone", "bolts { stiffness: 1e7 } ", "joint",
             "no faces between which they act; give `contact`"},
        Case{"gasket_alone", "gasket { position: 0.1 " + kCurve + "} ", "joint", "give `contact`"},
        Case{"bolt_outside", kContact + "bolts { stiffness: 1e7 position: -0.18 } ",
             "joint.bolts[0].position",
             "is -0.18 m, outside the section, which reaches 0.175 m from the axis to either side"},
        Case{"pretension_beyond_yield",
             kContact + "bolts { stiffness: 1e7 pretension: 2e5 yield_force: 1e5 } ",
             "joint.bolts[0].pretension", "is 2e+05 N, more than the yield force of 1e+05 N; give less"},
        Case{"pretension_beside_the_faces",
             kContact + "bolts { stiffness: 1e7 pretension: 1e5 position: 0.12 } ", "joint.bolts",
             "which reaches 0.1 m from the axis to either side, and nothing balances it"},
        Case{"gasket_outside", kContact + "gasket { position: 0.2 " + kCurve + "} ", "joint.gasket.position",
             "outside the section"},
        Case{"gasket_that_pulls",
             kContact + "gasket { position: 0.1 force { opening: [-1e-3, 0] force: [60e3, 0] } } ",
             "joint.gasket.force.force", "must rise to 0 where the gasket lets go"},
        Case{"water_without_width", kContact + "gasket { position: 0.1 water_pressure: 1e5 " + kCurve + "} ",
             "joint.gasket", "give `width` and `water_pressure`, or neither"}),
    [](const auto& refused) { return refused.param.name; });

}  // namespace
}  // namespace adit::fdm::test::segments_test

// Overlaps that can be computed but are badly laid get a note.
#include "coupler/bridging/overlap_notes.hpp"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>

#include "tests/support/overlaps.hpp"

namespace adit::coupler {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<double> grid(double half, double step) {
  std::vector<double> points;
  const int n = static_cast<int>(std::lround(half / step));
  for (int i = -n; i <= n; ++i)
    for (int j = -n; j <= n; ++j) points.insert(points.end(), {i * step, j * step});
  return points;
}

const std::vector<double> kZones = grid(10, 0.25), kParticles = grid(4, 0.1);  // zones of 0.5 m

scene::Scene part(const std::string& text) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(
      "material { young_modulus: 163e6 poisson_ratio: 0.2 density: 1800 }" + text, &scene))
      << text;
  return scene;
}

std::vector<std::string> notes(double radius, double width, const std::string& particles) {
  return overlap_notes(test::overlap_of(test::ring(test::circle(0, 0, radius), width)),
                       {"continuum", part("continuum { }"), kZones},
                       {"particles", part("particles { " + particles + " }"), kParticles});
}

// Requirement: an overlap of one zone passes, a narrower one is noted with both widths.
TEST(OverlapNotes, AnOverlapNarrowerThanAZone) {
  EXPECT_THAT(notes(3, 0.5, ""), IsEmpty());
  EXPECT_THAT(notes(3, 0.3, ""),
              ElementsAre(HasSubstr(
                  "interface.overlap is 0.3 m wide, less than a zone of `continuum` there (0.5 m)")));
}

// Requirement: an overlap inside a lining is noted with both stiffnesses, one in the ground beside it is not.
TEST(OverlapNotes, AnOverlapInALining) {
  const std::string lining =
      "groups { name: 'lining' where { circle { centre { x: 0 y: 0 } radius: 2.5 } } "
      "material { young_modulus: 35e9 poisson_ratio: 0.2 density: 2500 } }";
  EXPECT_THAT(notes(2.6, 1, lining), IsEmpty());
  EXPECT_THAT(notes(2, 1, lining), ElementsAre(HasSubstr("between 0.163 GPa of `continuum` and 35 GPa of "
                                                         "`particles`; lay it through ground")));
}

// Requirement: stiffnesses that bonds state themselves are not compared with a material.
TEST(OverlapNotes, BondsOfTheirOwnStiffnessAreNotCompared) {
  const std::string stiff = "material { young_modulus: 35e9 poisson_ratio: 0.2 density: 2500 }";
  EXPECT_THAT(notes(2, 1, stiff), ElementsAre(HasSubstr("35 GPa")));
  EXPECT_THAT(notes(2, 1, stiff + "bonds { normal_stiffness: 1e9 shear_stiffness: 1e9 }"), IsEmpty());
}

}  // namespace
}  // namespace adit::coupler

// Overlaps that can be computed but are badly laid get a note.
#include "coupler/bridging/overlap_notes.hpp"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>

#include "tests/support/overlaps.hpp"

namespace adit::coupler::overlap_notes_test {
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

std::vector<std::string> notes(double radius, double width) {
  return overlap_notes(test::overlap_of(test::ring(test::circle(0, 0, radius), width)),
                       {"continuum", "continuum", part("continuum { }"), kZones},
                       {"particles", "particles", part("particles { }"), kParticles});
}

// Requirement: an overlap of one zone passes, a narrower one is noted with both widths.
TEST(OverlapNotes, AnOverlapNarrowerThanAZone) {
  EXPECT_THAT(notes(3, 0.5), IsEmpty());
  EXPECT_THAT(notes(3, 0.3),
              ElementsAre(HasSubstr(
                  "interface.overlap is 0.3 m wide, less than a zone of `continuum` there (0.5 m)")));
}

}  // namespace
}  // namespace adit::coupler::overlap_notes_test

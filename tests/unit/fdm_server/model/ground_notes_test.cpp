// Requirement: damping of loops that is asked for and cannot be given is told, with both numbers.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "fdm_server/model/ground.hpp"

namespace adit::fdm {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// G/Gmax falls to 0.9 at 1e-4, where Masing's rules give about 2 %.
std::vector<std::string> notes(const std::string& ratios) {
  scene::Scene scene;
  const std::string text = fmt::format(
      "material {{ young_modulus: 104e6 poisson_ratio: 0.3 density: 1800 hysteretic {{ memory: REVERSALS "
      "table {{ shear_strain: [1e-6, 1e-5, 1e-4, 1e-3, 1e-2] ratio: [1, 0.99, 0.9, 0.5, 0.14] }} "
      "damping {{ table {{ shear_strain: [1e-6, 1e-4, 1e-2] ratio: [{}] }} }} }} }} continuum {{ }}",
      ratios);
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &scene)) << text;
  return notes_on_loops(scene, read_ground(scene));
}

TEST(NotesOnLoops, TellWhereATableAsksForMoreThanMasingsRulesGive) {
  EXPECT_THAT(notes("0.0001, 0.04, 0.1"), ElementsAre(AllOf(HasSubstr("asks for 4 %"), HasSubstr("0.0001"))));
}

TEST(NotesOnLoops, AreNoneWhereLoopsFollowTheTable) {
  EXPECT_THAT(notes("0.00001, 0.01, 0.1"), IsEmpty());
}

}  // namespace
}  // namespace adit::fdm

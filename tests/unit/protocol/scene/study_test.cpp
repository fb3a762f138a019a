// The file of a study is read as a scene is: units, limits, and one line for what is wrong.
#include "protocol/scene/study.hpp"

#include <gmock/gmock.h>

#include "protocol/errors.hpp"
#include "tests/support/scratch_folder.hpp"

namespace adit::protocol::study_test {
namespace {

using test::ScratchFolder;
using ::testing::EndsWith;
using ::testing::HasSubstr;

study::Study read(const std::string& text) {
  const ScratchFolder folder;
  return read_study(folder.write("s.yaml", text));
}

std::string complaint(const std::string& text) {
  try {
    read(text);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

TEST(Study, ConvertsLevelsOfIntensityToSi) {
  const auto study = read("{scene: a.yaml, motions: {stripes: {pga: [0.1 g, 150 gal]}}, questions: [x]}");
  EXPECT_DOUBLE_EQ(study.motions().stripes().pga(0), 0.980665);
  EXPECT_DOUBLE_EQ(study.motions().stripes().pga(1), 1.5);
}

TEST(Study, NamesAnUnknownKeyWithItsPlaceAndTheNearest) {
  EXPECT_THAT(complaint("scene: a.yaml\nrandom:\n  - {name: e, key: [material.young_modulus]}\n"),
              HasSubstr("s.yaml:3:15: random[0].key: unknown; did you mean `keys`?"));
}

TEST(Study, RefusesWhatHasNoScene) {
  EXPECT_THAT(complaint("questions: [x]\n"), HasSubstr("scene: "));
}

TEST(Study, RefusesLevelsThatDoNotRiseAndNamesTheirPlace) {
  EXPECT_THAT(complaint("scene: a.yaml\nmotions:\n  increments: {pga: [0.2 g, 0.1 g]}\n"),
              HasSubstr("s.yaml:3:29: motions.increments.pga[1]: "));
}

TEST(Study, RefusesAWidthThatIsNotPositive) {
  EXPECT_THAT(complaint("{scene: a.yaml, random: [{name: e, lognormal: {median: 1, dispersion: 0}}]}"),
              EndsWith("random[0].lognormal.dispersion: is 0, expected a pure number above 0"));
}

}  // namespace
}  // namespace adit::protocol::study_test

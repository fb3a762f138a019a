// What identifies a variant of a scene, and what is wrong with it, is told without computing it.
#include "coupler/variants/variants.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "protocol/errors.hpp"
#include "tests/support/scratch_folder.hpp"

namespace adit::coupler::variants_test {
namespace {

using nlohmann::json;
using test::ScratchFolder;
using ::testing::HasSubstr;

constexpr const char* kColumn = R"(
material: {young_modulus: 100 MPa, poisson_ratio: 0.3, density: 2 t/m^3}
time: {duration: 4 s}
statics: {unbalanced_ratio: 1e-4}
continuum:
  block: {x_min: 0 m, x_max: 1 m, y_min: 0 m, y_max: 10 m, zones_x: 1, zones_y: 10}
  base: {acceleration: {sine: {frequency: 1 Hz, end: 2 s}, peak: 3}}
)";

std::vector<json> told(const std::vector<std::string>& lines, const Measured& measured = {}) {
  const ScratchFolder folder;
  std::stringstream in, out;
  for (const std::string& line : lines) in << line << "\n";
  tell_variants(folder.write("x.yaml", kColumn), measured, in, out);
  std::vector<json> found;
  for (std::string line; std::getline(out, line);) found.push_back(json::parse(line));
  return found;
}

TEST(Variants, ScenesAreTheSameWhereTheyComputeTheSame) {
  const auto found = told({"{}", R"({"material.young_modulus": "0.1 GPa"})",
                           R"({"material.young_modulus": "90 MPa"})", R"({"description": "another text"})"});
  EXPECT_EQ(found[0], found[1]);
  EXPECT_NE(found[0]["hash"], found[2]["hash"]);
  EXPECT_EQ(found[0], found[3]);
}

TEST(Variants, TheStateAtRestDoesNotDependOnTheMotion) {
  const auto found = told({"{}", R"({"continuum.base.acceleration": "{ricker: {frequency: 2, time: 1}}"})",
                           R"({"time.duration": "1 s", "output": "{field_times: [1]}"})",
                           R"({"statics.unbalanced_ratio": "1e-5"})", R"({"time.substeps": "2"})"});
  EXPECT_NE(found[0]["hash"], found[1]["hash"]);
  EXPECT_EQ(found[0]["statics"], found[1]["statics"]);
  EXPECT_EQ(found[0]["statics"], found[2]["statics"]);
  EXPECT_NE(found[0]["statics"], found[3]["statics"]);
  EXPECT_NE(found[0]["statics"], found[4]["statics"]);
}

TEST(Variants, AValueThatIsRefusedIsOneLineOfTheAnswer) {
  const auto found =
      told({R"({"material.young_modulus": "-1 MPa"})", R"({"material.youngs_modulus": "1 MPa"})",
            R"({"material.young_modulus": "1 m"})", "{}"});
  EXPECT_THAT(found[0]["error"].get<std::string>(), HasSubstr("expected a pressure above 0 Pa"));
  EXPECT_THAT(found[1]["error"].get<std::string>(), HasSubstr("did you mean `young_modulus`?"));
  EXPECT_THAT(found[2]["error"].get<std::string>(), HasSubstr("is a length"));
  EXPECT_TRUE(found[3].contains("hash"));
}

// Two periods of 3 m/s^2 sin(2 pi t): v = 3/(2 pi) (1 - cos 2 pi t) before the baseline is corrected, the
// Arias intensity is pi/(2 g) times 9/2 m^2/s^4 times 2 s.
TEST(Variants, MeasuresTheMotion) {
  Measured measured{.asked = true, .key = {}, .periods = {0.01}};
  const json motion = told({R"({"continuum.base.acceleration.baseline": "false"})"}, measured)[0]["motion"];
  EXPECT_EQ(motion["key"], "continuum.base.acceleration");
  EXPECT_NEAR(motion["pga"], 3, 1e-3);
  EXPECT_NEAR(motion["pgv"], 3 / std::numbers::pi, 1e-3);
  EXPECT_NEAR(motion["arias"], std::numbers::pi / (2 * 9.80665) * 9, 1e-3);
  EXPECT_NEAR(motion["sa"][0], 3, 0.02);  // a stiff oscillator follows the ground
}

TEST(Variants, WhatIsNoMotionIsRefused) {
  Measured measured{.asked = true, .key = "continuum.block", .periods = {}};
  EXPECT_THAT(told({"{}"}, measured)[0]["error"].get<std::string>(), HasSubstr("no ground motion"));
}

TEST(Variants, WhatIsNoObjectOfTextsIsRefused) {
  EXPECT_THROW(told({"3"}), protocol::UserError);
  EXPECT_THROW(told({R"({"time.duration": 3})"}), protocol::UserError);
}

}  // namespace
}  // namespace adit::coupler::variants_test

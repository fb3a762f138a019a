// Requirements on reinforced sections as scenes state them: bars lie where they are said to, and what
// contradicts itself is refused in one sentence.
#include "fdm_server/model/supports/reinforced_section.hpp"

#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/support/refusals.hpp"

namespace adit::fdm::test::reinforced_section_test {
namespace {

const std::string kClasses = "concrete { class: 'C30/37' } steel { class: 'B500B' } ",
                  kBars = "outer { diameter: 0.016 spacing: 0.2 } inner { diameter: 0.012 spacing: 0.1 } ",
                  kWall = "thickness: 0.3 cover: 0.04 ";

scene::ReinforcedSection section(const std::string& text) {
  scene::ReinforcedSection section;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &section)) << text;
  return section;
}

// Requirement: the cover counts from either face to the surface of the bars; outer bars are at the right of
// the path; an area per metre stands for a spacing.
TEST(ReinforcedSection, BarsLieUnderTheirCover) {
  const auto read = read_reinforced_section(section(kWall + kClasses + kBars), 1, 1, "");
  const auto& bars = read->fibres->shape().bars;
  ASSERT_EQ(bars.size(), 2U);
  EXPECT_NEAR(bars[0].position, -(0.15 - 0.04 - 0.006), 1e-12);
  EXPECT_NEAR(bars[0].area, 1131e-6, 1e-6);
  EXPECT_NEAR(bars[1].position, 0.15 - 0.04 - 0.008, 1e-12);
  EXPECT_NEAR(bars[1].area, 1005e-6, 1e-6);
  const auto by_area = read_reinforced_section(
      section(kWall + kClasses + "outer { diameter: 0.016 area: 1005e-6 }"), 1, 1, "");
  EXPECT_NEAR(by_area->fibres->shape().bars[0].area, 1005e-6, 1e-12);
}

// Requirement: design values give less than mean values, by about the partial factors.
TEST(ReinforcedSection, ValuesAreChosen) {
  const auto mean = read_reinforced_section(section(kWall + kClasses + kBars + "values: MEAN"), 1, 1, "");
  const auto design = read_reinforced_section(section(kWall + kClasses + kBars + "values: DESIGN"), 1, 1, "");
  EXPECT_NEAR(design->strength.capacity.largest_thrust() / mean->strength.capacity.largest_thrust(),
              500 / 1.15 / 550, 1e-3);
  EXPECT_NEAR(design->fibres->concrete(0).strength / mean->fibres->concrete(0).strength, 20.0 / 38, 1e-3);
}

using adit::test::RefusedText;

class Refused : public testing::TestWithParam<RefusedText> {};

TEST_P(Refused, InOneSentence) {
  const auto& [name, text, path, message] = GetParam();
  adit::test::expect_refusal([&text = text] { read_reinforced_section(section(text), 1, 1, "section"); },
                             path, message);
}

INSTANTIATE_TEST_SUITE_P(
    Sections, Refused,
    testing::Values(
        RefusedText{"outside",
                    "thickness: 0.3 cover: 0.29 " + kClasses + "outer { diameter: 0.02 spacing: 0.2 }",
                    "section.outer", "lies outside the section"},
        RefusedText{"meeting", "thickness: 0.3 cover: 0.14 " + kClasses + kBars, "section.cover",
                    "meet in the middle"},
        RefusedText{"close", kWall + kClasses + "outer { diameter: 0.02 spacing: 0.03 }",
                    "section.outer.spacing", "closer than their diameter"},
        RefusedText{"crowded", kWall + kClasses + "outer { diameter: 0.02 area: 0.02 }", "section.outer.area",
                    "closer than their diameter"},
        RefusedText{"twice", kWall + kClasses + "outer { diameter: 0.02 area: 0.001 spacing: 0.2 }",
                    "section.outer", "give either `spacing` or `area`"},
        RefusedText{"no_cover", "thickness: 0.3 " + kClasses + kBars, "section.inner", "no `cover`"},
        RefusedText{
            "mixed",
            kWall + kBars + "concrete { class: 'C30/37' } steel { yield_strength: 500e6 } values: DESIGN",
            "section", "gives its concrete by class and its steel by numbers"},
        RefusedText{
            "values_of_numbers",
            kWall + kBars +
                "concrete { young_modulus: 30e9 compressive_strength: 30e6 tensile_strength: 2e6 } steel { "
                "yield_strength: 500e6 } values: DESIGN",
            "section.values", "chooses among the values of classes"},
        RefusedText{"concrete_twice",
                    kWall + kBars + "concrete { class: 'C30' young_modulus: 3e10 } steel { class: 'HRB400' }",
                    "section.concrete", "needs its strength once"},
        RefusedText{"concrete_half",
                    kWall + kBars + "concrete { young_modulus: 3e10 } steel { yield_strength: 5e8 }",
                    "section.concrete", "needs its strength once"},
        RefusedText{
            "soft_concrete",
            kWall + kBars +
                "concrete { young_modulus: 1e10 compressive_strength: 40e6 tensile_strength: 2e6 } steel { "
                "yield_strength: 500e6 }",
            "section.concrete.young_modulus", "too small for a compressive strength"},
        RefusedText{"unknown_concrete",
                    kWall + kBars + "concrete { class: 'C31/37' } steel { class: 'B500B' }",
                    "section.concrete.class", "is `C31/37`, expected a class of EN 1992-1-1"},
        RefusedText{"unknown_steel", kWall + kBars + "concrete { class: 'C30/37' } steel { class: 'B500D' }",
                    "section.steel.class", "did you mean"},
        RefusedText{"steel_twice",
                    kWall + kBars + "concrete { class: 'C30/37' } steel { class: 'B500B' hardening: 0.1 }",
                    "section.steel", "needs its strength once"},
        RefusedText{"no_steel", kWall + kBars + "concrete { class: 'C30/37' }", "section.steel",
                    "is missing, but there are bars"},
        RefusedText{"no_bars", kWall + kClasses, "section.steel", "there are no bars"},
        RefusedText{"plain", "thickness: 0.3 concrete { class: 'C30/37' }", "section",
                    "neither bars nor fibres"},
        RefusedText{"stirrups_alone",
                    "thickness: 0.3 concrete { class: 'C40/50' fibres { residual_strength_1: 4e6 "
                    "residual_strength_3: 3e6 } } "
                    "stirrups { diameter: 0.01 spacing: 0.2 spacing_across: 0.3 }",
                    "section.stirrups", "cannot hold them"}),
    adit::test::kRefusalName);

}  // namespace
}  // namespace adit::fdm::test::reinforced_section_test

// Requirement: damping that is asked for and does not act as it is meant is told, with its numbers.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "fdm_server/model/damping.hpp"
#include "fdm_server/model/ground.hpp"

namespace adit::fdm::ground_notes_test {
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

// Requirement: the strength that a curve of stiffness implies is told. G = 40 MPa; the table's stress at its
// last strain is 40 MPa x 0.5 x 0.1 %, that of the hyperbola at ten times its reference strain 40 MPa x 0.5
// %/11.
TEST(NotesOnStrength, TellTheLargestStressOfEveryCurve) {
  const std::string constants = "young_modulus: 104e6 poisson_ratio: 0.3 density: 1800 ";
  scene::Scene scene;
  ASSERT_TRUE(google::protobuf::TextFormat::ParseFromString(
      "material { " + constants +
          "hysteretic { table { shear_strain: [1e-6, 1e-4, 1e-3] ratio: [1, 0.9, 0.5] } } } "
          "continuum { materials { material { " +
          constants + "} } materials { material { " + constants +
          "hysteretic { memory: REVERSALS hyperbola { reference_strain: 5e-4 } } } } }",
      &scene));
  const std::vector<std::string> notes = notes_on_strength(read_ground(scene));
  EXPECT_THAT(notes, ElementsAre(AllOf(HasSubstr("the material reaches"), HasSubstr(" 20 kPa, at 0.1 % of")),
                                 AllOf(HasSubstr("continuum.materials[1] reaches"),
                                       HasSubstr(" 18.2 kPa, at 0.5 % of"))));
}

// Requirement: what follows from a cyclic resistance is told, in the words of the keys that would state it.
TEST(NotesOnSand, TellWhatFollowsFromACyclicResistance) {
  const std::string constants = "young_modulus: 104e6 poisson_ratio: 0.3 density: 1800 ";
  scene::Scene scene;
  ASSERT_TRUE(google::protobuf::TextFormat::ParseFromString(
      "material { " + constants +
          "pm4sand { relative_density: 0.55 modulus_coefficient: 677 contraction_rate: 0.4 } } "
          "continuum { materials { material { " +
          constants +
          "pm4sand { relative_density: 0.65 cyclic_resistance: 0.199 } } } materials { where {} material { " +
          constants +
          "mohr_coulomb { cohesion: 0 friction_angle: 0.576 } pores { porosity: 0.4 compaction { "
          "cyclic_resistance: 0.147 } } } } }",
      &scene));
  const Ground ground = read_ground(scene);
  EXPECT_THAT(
      notes_on_resistance(scene, ground),
      ElementsAre(AllOf(HasSubstr("continuum.materials[0]: cyclic_resistance 0.199 makes"),
                        HasSubstr("contraction_rate of 0.41"), HasSubstr("modulus_coefficient 782")),
                  HasSubstr("compaction of continuum.materials[1]: cyclic_resistance 0.147 makes C1 = 0.2")));
  EXPECT_EQ(ground.materials[0].pm4sand->contraction_rate, 0.4);
}

// Zones that only state a fracture do not break: told of each material, not where a law yields instead.
TEST(NoteOnFracture, NamesWhatStaysElastic) {
  const std::string constants = "young_modulus: 104e6 poisson_ratio: 0.3 density: 1800 ",
                    fracture = "fracture { tensile_strength: 1e6 fracture_energy: 50 cohesion: 3e6 } ";
  const auto note = [&](const std::string& first) {
    scene::Scene scene;
    EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(
        "material { " + constants + first + "} continuum { materials { material { " + constants + fracture +
            "mohr_coulomb { cohesion: 1e5 } } } materials { material { " + constants + "} } }",
        &scene));
    return note_on_fracture(read_ground(scene));
  };
  EXPECT_THAT(note(fracture),
              testing::Optional(HasSubstr("fracture of the material: zones do not break by it")));
  EXPECT_EQ(note(""), std::nullopt);
}

// Rayleigh's ratio between two frequencies is 2 sqrt(f1 f2)/(f1 + f2) of the stated one: 0.8 of it at 2 Hz
// from 1 to 4 Hz, 0.98 of it from 1 to 1.5 Hz, of which nothing is told.
TEST(NoteOnRatio, TellsWhereRayleighsRatioFallsBetweenItsFrequencies) {
  const auto note = [](double high_frequency) {
    scene::Continuum continuum;
    auto& rayleigh = *continuum.mutable_damping()->mutable_rayleigh();
    rayleigh.set_ratio(0.01);
    rayleigh.set_low_frequency(1);
    rayleigh.set_high_frequency(high_frequency);
    return note_on_ratio(continuum, resolve_damping(continuum));
  };
  EXPECT_THAT(note(4), testing::Optional(HasSubstr("is 0.01 at 1 Hz, 0.008 at 2 Hz and 0.01 at 4 Hz")));
  EXPECT_EQ(note(1.5), std::nullopt);
}

// A base that shakes at w with the acceleration A moves with up to 2 A/w from rest; alpha of that beside A.
TEST(NoteOnSharedMotion, TellsWhatDampingOfMassesTakesFromTheMotionOfTheBase) {
  constexpr double kAngular = 2;
  motion::Motion base{.dt = 0.01, .acceleration = {}};
  for (int i = 0; i < 1000; ++i) base.acceleration.push_back(3 * std::sin(kAngular * 0.01 * i));
  EXPECT_THAT(note_on_shared_motion({.alpha = 0.5}, base), testing::Optional(HasSubstr("50 %")));
  EXPECT_EQ(note_on_shared_motion({.alpha = 0.04}, base), std::nullopt);
  EXPECT_EQ(note_on_shared_motion({}, base), std::nullopt);
}

}  // namespace
}  // namespace adit::fdm::ground_notes_test

// Each kind of rule that scene.proto states is checked in a message, wherever it came from.
#include "protocol/scene/fields/check_rules.hpp"

#include <google/protobuf/text_format.h>

#include <string>

#include "protocol/messages/scene.pb.h"
#include "tests/support/refusals.hpp"

namespace adit::protocol::check_rules_test {
namespace {

template <class Message>
Message parsed(const std::string& text) {
  Message message;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &message)) << text;
  return message;
}

template <class Message>
void expect_refused(const std::string& message, const std::string& path, const std::string& text) {
  test::expect_refusal([&] { check_rules(parsed<Message>(message), "here"); }, "here." + path, text);
}

template <class Message>
void expect_accepted(const std::string& message) {
  EXPECT_NO_THROW(check_rules(parsed<Message>(message))) << message;
}

TEST(CheckRules, NumbersLieWithinTheirLimits) {
  const std::string solid = "young_modulus: 1e9 density: 2000 ";
  expect_accepted<scene::Material>(solid + "poisson_ratio: 0.49");
  expect_refused<scene::Material>(solid + "poisson_ratio: 0.5", "poisson_ratio",
                                  "is 0.5, expected a pure number above -1 and below 0.5");
  expect_refused<scene::Material>(solid + "poisson_ratio: -1", "poisson_ratio", "is -1, expected");
  expect_accepted<scene::ParticleContacts>("shear_stiffness: 0");
  expect_refused<scene::ParticleContacts>("shear_stiffness: -1e-9", "shear_stiffness",
                                          "is -1e-09 N/m, expected a stiffness of at least 0 N/m");
  expect_accepted<scene::Time>("duration: 1 dt_factor: 1 substeps: 1000");
  expect_refused<scene::Time>("duration: 1 dt_factor: 1.5", "dt_factor", "above 0 and at most 1");
  expect_refused<scene::Time>("duration: 1 substeps: 1001", "substeps",
                              "is 1001, expected a whole number at most 1000");
  expect_refused<scene::Statics>("max_steps: 0", "max_steps", "is 0, expected a whole number above 0");
}

// Degrees without their unit would be taken as radians; an arc may end in its second turn.
TEST(CheckRules, AnglesLieWithinTwoTurns) {
  expect_accepted<scene::WeakPlane>("dip_angle: 12.5 cohesion: 0");
  expect_accepted<scene::WeakPlane>("dip_angle: -12.5 cohesion: 0");
  expect_refused<scene::WeakPlane>(
      "dip_angle: 70 cohesion: 0", "dip_angle",
      "is 70 rad, expected an angle within two turns; a number without a unit is in "
      "radians, in degrees it is `70 deg`");
  expect_refused<scene::WeakPlane>("dip_angle: -20 cohesion: 0", "dip_angle", "`-20 deg`");
}

TEST(CheckRules, NumbersAreFiniteWhereTheirDefaultIs) {
  expect_refused<scene::Point>("x: nan y: 0", "x", "is not a number, expected a length such as `0.5 m`");
  expect_refused<scene::Point>("x: 0 y: -inf", "y", "is infinite, expected a length such as `0.5 m`");
  expect_accepted<scene::Bonds>("tensile_strength: inf");
  expect_refused<scene::Bonds>("tensile_strength: -inf", "tensile_strength", "is -inf N, expected");
  expect_refused<scene::Bonds>("tensile_strength: nan", "tensile_strength", "is not a number");
  expect_refused<scene::Output>("field_times: 1 field_times: nan", "field_times[1]", "is not a number");
}

TEST(CheckRules, RequiredFieldsAreThere) {
  expect_refused<scene::Circle>("radius: 1", "centre",
                                "is missing; write for example `centre: {x: 0.5 m, y: 0.5 m}`");
  expect_refused<scene::Circle>("centre { x: 1 } radius: 1", "centre.y",
                                "is missing; write for example `y: 0.5 m`");
  expect_refused<scene::ParticleGroup>("name: ''", "name", "is missing; write for example `name: some_name`");
  expect_refused<scene::Polygon>("", "corners", "is missing; write for example `corners: [{x: 0, y: 0},");
}

// Names become parts of names of files and columns, and stand in reports and on terminals.
TEST(CheckRules, NamesAreFitForFiles) {
  for (const std::string& name : {std::string("top-2.b_c"), std::string("Übergang"), std::string(100, 'x')})
    expect_accepted<scene::ParticleGroup>("name: '" + name + "' where { x_min: 0 }");
  for (const std::string& name :
       {std::string("../x"), std::string("a/b"), std::string(".x"), std::string("a b"), std::string("a\\nb"),
        std::string("a,b"), std::string(101, 'x')})
    expect_refused<scene::ParticleGroup>("name: '" + name + "'", "name",
                                         "expected a name of letters, digits, `_`, `-`");
}

// What a reader does not see must not stand in a name, nor must bytes that are not UTF-8: control characters,
// separators, blanks of any width, what turns the direction of writing, and what has no width.
TEST(CheckRules, NamesAreSeenAsTheyAre) {
  for (const std::string unseen :
       {"\u0085", "\u00a0", "\u00ad", "\u061c", "\u200b", "\u200d", "\u200e", "\u2028", "\u2029", "\u202e",
        "\u2060", "\u2066", "\u2069", "\u3000", "\ufeff", "\U000e0041", "\xe4"})
    expect_refused<scene::ParticleGroup>("name: 'a" + unseen + "b'", "name",
                                         "expected a name of letters, digits, `_`, `-`");
  for (const std::string seen : {"\u00dcbergang", "\u0928\u0940", "\u96a7\u9053", "\U0001f687"})
    expect_accepted<scene::ParticleGroup>("name: '" + seen + "' where { x_min: 0 }");
}

TEST(CheckRules, FieldsStandInTheRelationTheyName) {
  const std::string low = "x_min: 2 y_min: 0 y_max: 1 ";
  expect_accepted<scene::Box>(low + "x_max: 2.5");
  expect_refused<scene::Box>(low + "x_max: 2", "x_max", "is 2 m, expected a length above `x_min` = 2 m");
  const std::string damping = "ratio: 0.1 low_frequency: 5 ";
  expect_accepted<scene::RayleighDamping>(damping + "high_frequency: 5");
  expect_refused<scene::RayleighDamping>(damping + "high_frequency: 4", "high_frequency",
                                         "is 4 Hz, expected a frequency of at least `low_frequency` = 5 Hz");
  expect_accepted<scene::Area>("x_min: 2 x_max: 1");  // no rule of Area: it then selects nothing
}

// Defaults take part in relations.
TEST(CheckRules, ADefaultStandsInItsRelationToo) {
  expect_accepted<scene::Spectra>("history: 'top'");
  expect_refused<scene::Spectra>("history: 'top' shortest_period: 6", "longest_period",
                                 "is 5 s, expected a time above `shortest_period` = 6 s");
  expect_accepted<scene::GroundMotion>("high_corner: 2");
}

TEST(CheckRules, ListsHaveTheirLengthAndOrder) {
  const std::string two = "corners { x: 0 y: 0 } corners { x: 1 y: 0 } ", third = "corners { x: 1 y: 1 } ";
  expect_refused<scene::Polygon>(two, "corners", "has 2 elements, expected at least 3");
  expect_accepted<scene::Polygon>(two + third);
  expect_refused<scene::Quadrilateral>(two + third, "corners", "has 3 elements, expected 4");
  expect_refused<scene::Quadrilateral>(two + two + third, "corners", "has 5 elements, expected 4");
  expect_refused<scene::Table>("time: 0 time: 1 value: 7", "value",
                               "has 1 elements, expected 2, as many as `time`");
  expect_refused<scene::Table>("time: 1 time: 1 value: 7 value: 8", "time[1]",
                               "is 1 s, expected more than the 1 s before it");
}

// A server that left out a key of a newer release would compute another model.
TEST(CheckRules, WhatIsNotKnownIsRefused) {
  auto material = parsed<scene::Material>("young_modulus: 1e9 poisson_ratio: 0.2 density: 2000");
  material.GetReflection()->MutableUnknownFields(&material)->AddVarint(99, 1);
  scene::Scene scene;
  *scene.mutable_continuum()->mutable_material() = material;
  test::expect_refusal([&] { check_rules(scene); }, "continuum.material", "(field 99 of Material)");

  scene::Continuum continuum;  // an enumerator that is not known
  ASSERT_TRUE(continuum.ParseFromString("\x10\x63"));
  test::expect_refusal([&] { check_rules(continuum, "here"); }, "here", "(field 2 of Continuum)");
}

// The path leads through messages and lists, and one message is checked to its end before its parent's
// missing fields.
TEST(CheckRules, PathsLeadToTheField) {
  test::expect_refusal(
      [] { check_rules(parsed<scene::Scene>("particles { loads {} loads { where {} force { x: inf } } }")); },
      "particles.loads[0].where", "is missing");
  test::expect_refusal(
      [] { check_rules(parsed<scene::Scene>("particles { loads { where {} force { x: inf } } }")); },
      "particles.loads[0].force.x", "is infinite, expected a force such as `5 MN`");
  test::expect_refusal([] { check_rules(scene::Scene()); }, "time",
                       "is missing; write for example `time: {duration");
}

}  // namespace
}  // namespace adit::protocol::check_rules_test

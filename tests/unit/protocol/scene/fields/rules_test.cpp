#include "protocol/scene/fields/rules.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "protocol/messages/scene.pb.h"
#include "protocol/scene/fields/units.hpp"
#include "protocol/scene/yaml/merge.hpp"
#include "protocol/scene/yaml/message_reader.hpp"

namespace adit::protocol {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;

const FieldDescriptor* field(const Descriptor* type, const char* name) {
  return type->FindFieldByName(name);
}

TEST(SceneRules, ExpectationsStateTypeUnitAndLimits) {
  EXPECT_EQ(expectation(field(scene::HexagonalPacking::descriptor(), "radius")), "a length above 0 m");
  EXPECT_EQ(expectation(field(scene::Material::descriptor(), "poisson_ratio")),
            "a pure number above -1 and below 0.5");
  EXPECT_EQ(expectation(field(scene::Time::descriptor(), "dt_factor")),
            "a pure number above 0 and at most 1");
  EXPECT_EQ(expectation(field(scene::Point::descriptor(), "x")), "a length such as `0.5 m`");
  EXPECT_EQ(expectation(field(scene::Block::descriptor(), "zones_x")), "a whole number above 0");
  EXPECT_EQ(expectation(field(scene::Scene::descriptor(), "plane")), "one of plane_strain, plane_stress");
  EXPECT_EQ(expectation(field(scene::Scene::descriptor(), "base")), "a text");
  EXPECT_EQ(expectation(field(scene::Load::descriptor(), "force")), "a mapping such as `{x: 5 MN}`");
}

// Every unit that scene.proto names is coherent: a bare number needs no conversion.
TEST(SceneRules, EveryRuleNamesAnSiUnit) {
  const auto* file = scene::Scene::descriptor()->file();
  for (int m = 0; m < file->message_type_count(); ++m)
    for (int f = 0; f < file->message_type(m)->field_count(); ++f) {
      const auto& rule = rule_of(file->message_type(m)->field(f));
      if (!rule.has_unit()) continue;
      const Unit unit = parse_unit(rule.unit());
      EXPECT_EQ(unit.decimals, 0) << rule.unit();
      EXPECT_EQ(unit.factor, 1) << rule.unit();
    }
}

// What a message tells the user to write is accepted when it is written.
TEST(SceneRules, EveryExampleCanBeRead) {
  const auto* file = scene::Scene::descriptor()->file();
  for (int m = 0; m < file->message_type_count(); ++m) {
    const Descriptor* type = file->message_type(m);
    for (int f = 0; f < type->field_count(); ++f) {
      const FieldDescriptor* field = type->field(f);
      // The example of the message, with the field itself where that leaves it out.
      YamlValue tree = parse_yaml(example(type), "example");
      merge(tree, parse_yaml("{" + field->name() + ": " + example(field) + "}", "example"), type);
      const std::unique_ptr<google::protobuf::Message> message(
          google::protobuf::MessageFactory::generated_factory()->GetPrototype(type)->New());
      EXPECT_NO_THROW(read_message(tree, "", *message)) << field->full_name();
    }
  }
}

}  // namespace
}  // namespace adit::protocol

#include "protocol/scene/fields/rules.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "protocol/messages/scene.pb.h"
#include "protocol/scene/fields/check_rules.hpp"
#include "protocol/scene/fields/units.hpp"
#include "protocol/scene/yaml/merge.hpp"
#include "protocol/scene/yaml/message_reader.hpp"

namespace adit::protocol::rules_test {
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
  EXPECT_EQ(expectation(field(scene::Scene::descriptor(), "extends")), "a text");
  EXPECT_EQ(expectation(field(scene::Load::descriptor(), "force")), "a mapping such as `{x: 5 MN}`");
}

// The messages of scene.proto and of what it imports.
std::vector<const Descriptor*> all_messages() {
  const auto* scene = scene::Scene::descriptor()->file();
  std::vector<const google::protobuf::FileDescriptor*> files{scene};
  for (int i = 0; i < scene->dependency_count(); ++i) files.push_back(scene->dependency(i));
  std::vector<const Descriptor*> messages;
  for (const auto* file : files)
    for (int m = 0; m < file->message_type_count(); ++m) messages.push_back(file->message_type(m));
  return messages;
}

// Every unit that the scene's definition names is coherent: a bare number needs no conversion.
TEST(SceneRules, EveryRuleNamesAnSiUnit) {
  for (const Descriptor* type : all_messages())
    for (int f = 0; f < type->field_count(); ++f) {
      const auto& rule = rule_of(type->field(f));
      if (!rule.has_unit()) continue;
      const Unit unit = parse_unit(rule.unit());
      EXPECT_EQ(unit.decimals, 0) << rule.unit();
      EXPECT_EQ(unit.factor, 1) << rule.unit();
    }
}

// A rule that names a field beside its own names one of the same kind.
TEST(SceneRules, EveryFieldThatARuleNamesStandsBesideIt) {
  for (const Descriptor* type : all_messages())
    for (int f = 0; f < type->field_count(); ++f) {
      const FieldDescriptor* field = type->field(f);
      const scene::Rule& rule = rule_of(field);
      for (const std::string& name : {rule.above_field(), rule.at_least_field(), rule.as_many_as()}) {
        if (name.empty()) continue;
        const FieldDescriptor* other = type->FindFieldByName(name);
        ASSERT_NE(other, nullptr) << field->full_name();
        EXPECT_EQ(other->is_repeated(), field->is_repeated()) << field->full_name();
        EXPECT_EQ(other->cpp_type(), field->cpp_type()) << field->full_name();
      }
    }
}

// What a message tells the user to write is accepted when it is written.
TEST(SceneRules, EveryExampleIsAccepted) {
  for (const Descriptor* type : all_messages())
    for (int f = 0; f < type->field_count(); ++f) {
      const FieldDescriptor* field = type->field(f);
      if (is_internal(field)) continue;
      // The example of the message, with the field itself where that leaves it out.
      YamlValue tree = parse_yaml(example(type), "example");
      merge(tree, parse_yaml("{" + field->name() + ": " + example(field) + "}", "example"), type);
      const std::unique_ptr<google::protobuf::Message> message(
          google::protobuf::MessageFactory::generated_factory()->GetPrototype(type)->New());
      EXPECT_NO_THROW({
        read_message(tree, "", *message);
        check_rules(*message);
      }) << field->full_name();
    }
}

}  // namespace
}  // namespace adit::protocol::rules_test

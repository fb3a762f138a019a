// Requirement: the stages of a scene are those in which any of its models changes, and displacements count
// from one of them.
#include "protocol/ground/stages.hpp"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/support/refusals.hpp"

namespace adit::protocol::stages_test {
namespace {

using testing::ElementsAre;

scene::Scene parse(const std::string& text) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &scene)) << text;
  return scene;
}

TEST(Stages, AreThoseInWhichAModelChanges) {
  EXPECT_THAT(stages_of(parse("")), ElementsAre(0));
  EXPECT_THAT(stages_of(parse("continuum { excavations { stage: 2 } linings { stage: 4 } bolts { stage: 6 } "
                              "motions { stage: 5 } materials { stage: 7 } } "
                              "particles { excavations { stage: 1 } groups { stage: 3 } } "
                              "regions { particles { joints { stage: 8 } springs { stage: 9 } } }")),
              ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8, 9));
}

// What is held at first is let go in the stage that follows; what is there from the beginning is not.
TEST(Stages, FollowWhereForcesAreHeld) {
  EXPECT_THAT(stages_of(parse("continuum { excavations { stage: 2 released: 0.3 } }")), ElementsAre(0, 2, 3));
  EXPECT_THAT(stages_of(parse("continuum { excavations { stage: 0 released: 0.3 } }")), ElementsAre(0));
}

TEST(Stages, CountFromOneThatTheSceneHas) {
  const std::string excavated = "continuum { excavations { stage: 1 released: 0.3 } } ";
  EXPECT_NO_THROW(require_counted_stage(parse(excavated + "statics { count_from_stage: 2 }")));
  EXPECT_NO_THROW(require_counted_stage(parse("statics { count_from_stage: 0 }")));
  EXPECT_NO_THROW(require_counted_stage(parse(excavated)));
  test::expect_refusal([&] { require_counted_stage(parse(excavated + "statics { count_from_stage: 3 }")); },
                       "statics.count_from_stage", "is 3, but the stages of the scene are 0, 1, 2");
}

}  // namespace
}  // namespace adit::protocol::stages_test

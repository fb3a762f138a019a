#include "protocol/scene/fields/computed.hpp"

#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <vector>

#include "protocol/errors.hpp"

namespace adit::protocol::computed_test {
namespace {

constexpr const char* kBar =
    "material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 } time { duration: 1 } "
    "continuum { block { x_min: 0 x_max: 4 y_min: 0 y_max: 1 zones_x: 4 zones_y: 1 } "
    "motions { where { x_max: 0 } velocity { x: 0 } } }";

// What is said against the bar with further `text`, by a participant that computes `keys`; empty: nothing.
std::string refusal(const std::string& text, const std::vector<std::string>& keys,
                    const std::string& path = "continuum") {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(kBar, &scene));
  EXPECT_TRUE(google::protobuf::TextFormat::MergeFromString(text, &scene)) << text;
  try {
    require_computed(scene, "continuum", path, {keys.begin(), keys.end()}, "their_code");
  } catch (const protocol::UserError& error) {
    return error.path() + " " + error.what();
  }
  return "";
}

const std::vector<std::string> kComputed = {
    "material.young_modulus", "material.poisson_ratio",        "material.density",          "time",
    "continuum.block",        "continuum.motions.where.x_max", "continuum.motions.velocity"};

TEST(Computed, AListedKeyIsTakenWithAllThatItHolds) {
  EXPECT_EQ(refusal("", kComputed), "");
}

// Requirement: no code can overlook a lining and end with exit code 0.
TEST(Computed, AnotherKeyIsRefusedByName) {
  EXPECT_EQ(refusal(" continuum { linings { name: 'ring' } }", kComputed),
            "continuum.linings is not computed by their_code; leave it out, or use another participant");
}

TEST(Computed, AKeyWithinAListIsNamedWithItsNumber) {
  EXPECT_EQ(refusal(" continuum { motions { where { circle { radius: 1 } } velocity { y: 0 } } }", kComputed),
            "continuum.motions[1].where.circle is not computed by their_code; leave it out, or use another "
            "participant");
}

TEST(Computed, ARegionIsNamedAsTheUserWroteIt) {
  EXPECT_EQ(refusal(" continuum { large_strain: true }", kComputed, "regions[0].continuum"),
            "regions[0].continuum.large_strain is not computed by their_code; leave it out, or use another "
            "participant");
}

TEST(Computed, AKeyThatSaysTheDefaultAsksForNothing) {
  EXPECT_EQ(refusal(" plane: PLANE_STRAIN continuum { large_strain: false zone: ASSUMED_STRAIN }", kComputed),
            "");
}

TEST(Computed, OneValueOfAKeyMayBeListed) {
  auto computed = kComputed;
  computed.push_back("continuum.zone.mixed_discretization");
  EXPECT_EQ(refusal(" continuum { zone: MIXED_DISCRETIZATION }", computed), "");
  EXPECT_EQ(refusal(" continuum { zone: MIXED_DISCRETIZATION }", kComputed),
            "continuum.zone is `mixed_discretization`, which is not computed by their_code; leave it out, or "
            "use another "
            "participant");
}

TEST(Computed, AKeyWhoseNameBeginsWithThatOfAnotherIsNotMeant) {
  auto computed = kComputed;
  computed.push_back("static");
  EXPECT_NE(refusal(" statics {}", computed), "");
}

TEST(Computed, WhoListsNothingTakesPartInNoRun) {
  EXPECT_NE(refusal("", {}).find("does not say in its hello what it computes"), std::string::npos);
}

}  // namespace
}  // namespace adit::protocol::computed_test

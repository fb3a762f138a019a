// Requirements on linings that lie on others: what they may lie on, and every error with its remedy.
#include "fdm_server/model/supports/layers.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocol/errors.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/fdm_server/scenes.hpp"
#include "tests/unit/fdm_server/supports/resolved.hpp"

namespace adit::fdm::test::layers_test {
namespace {

using adit::test::RefusedText;

const std::string kWall = "thickness: 0.3 young_modulus: 30e9 ";

std::string lining(const std::string& name, const std::string& more) {
  return fmt::format("linings {{ name: '{}' {} {} }} ", name, kWall, more);
}

const std::string kFirst = lining("first", "along { line { points { x: 0 y: 1 } points { x: 6 y: 1 } } }");

// A part of the path below is enough, in any order of the scene; three layers lie one on another.
TEST(Layers, FollowTheLiningBelow) {
  const Supports supports = resolved(
      lining("third", "on: 'second'") +
      lining("second", "on: 'first' along { line { points { x: 1 y: 1 } points { x: 4 y: 1 } } }") + kFirst);
  EXPECT_EQ(supports.linings[0].beams, 3u);
  EXPECT_EQ(supports.linings[0].path.points, supports.linings[1].path.points);
  EXPECT_EQ(supports.linings[2].beams, 6u);
}

// Bonded layers share the points of the one below; with an interface each point has a contact.
TEST(Layers, WithAnInterfaceHaveTheirOwnPoints) {
  EXPECT_TRUE(resolved(kFirst + lining("second", "on: 'first'")).contacts.empty());
  const Supports supports =
      resolved(kFirst + lining("second", "on: 'first' interface { friction_angle: 0.5 }"));
  EXPECT_EQ(supports.contacts.size(), 7u);
  for (const auto point : supports.linings[1].path.points)
    EXPECT_FALSE(std::ranges::count(supports.linings[0].path.points, point));
}

// A column stands on the last layer.
TEST(Layers, BearMembers) {
  const Supports supports = resolved(
      lining("second", "on: 'first' interface { friction_angle: 0.5 }") + kFirst +
      "members { name: 'column' from { x: 3 y: 1 } to { x: 3 y: 2 } spacing: 4 width: 0.5 thickness: 0.5 "
      "young_modulus: 30e9 }");
  EXPECT_EQ(supports.members[0].path.points.front(), supports.linings[0].path.points[3]);
}

class RefusedLayers : public testing::TestWithParam<RefusedText> {};

TEST_P(RefusedLayers, InOneSentence) {
  const auto& [name, text, path, message] = GetParam();
  adit::test::expect_refusal([&text = text] { resolved(text); }, "continuum." + path, message);
}

INSTANTIATE_TEST_SUITE_P(
    Layers, RefusedLayers,
    testing::Values(
        RefusedText{"unknown", kFirst + lining("second", "on: 'frist'"), "linings[1].on",
                    "did you mean `first`"},
        RefusedText{"itself", lining("second", "on: 'second'"), "linings[0].on", "no other lining"},
        RefusedText{"circle", lining("a", "on: 'b'") + lining("b", "on: 'a'"), "linings[0].on", "leads back"},
        RefusedText{
            "early",
            lining("second", "on: 'first'") +
                lining("first", "stage: 1 along { line { points { x: 0 y: 1 } points { x: 6 y: 1 } } }"),
            "linings[0].on", "not there yet in stage 0"},
        RefusedText{
            "elsewhere",
            kFirst +
                lining("second", "on: 'first' along { line { points { x: 0 y: 2 } points { x: 6 y: 2 } } }"),
            "linings[1].along", "leaves `first` at (0, 2) m"},
        RefusedText{"no_path", lining("first", ""), "linings[0]", "has no path"},
        RefusedText{"no_thickness",
                    "linings { name: 'first' area: 0.3 inertia: 0.002 young_modulus: 30e9 along { line { "
                    "points { x: 0 y: 1 } points { x: 6 y: 1 } } } } " +
                        lining("second", "on: 'first'"),
                    "linings[1].on", "`first` has no thickness"}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace adit::fdm::test::layers_test

// Requirements on rings beside one another: halves of the plane, points of their own, dowels in each width of
// a ring, and every error with its remedy.
#include "fdm_server/model/supports/rings.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/refusals.hpp"
#include "tests/unit/fdm_server/scenes.hpp"
#include "tests/unit/fdm_server/supports/resolved.hpp"

namespace adit::fdm::test::rings_test {
namespace {

const std::string kFriction = "interface { friction_angle: 0.5 } ";
const std::string kDowel = "dowels { at { x: 2 y: 1 } stiffness: 30e6 strength: 60e3 } ";

std::string lining(const std::string& name, const std::string& more) {
  return fmt::format("linings {{ name: '{}' thickness: 0.3 young_modulus: 30e9 {} }} ", name, more);
}

std::string first(const std::string& more = kFriction) {
  return lining("first", more + "along { line { points { x: 0 y: 1 } points { x: 6 y: 1 } } }");
}

std::string second(const std::string& dowels = kDowel, const std::string& more = kFriction,
                   const std::string& name = "second", const std::string& beside = "first") {
  return lining(name, more + fmt::format("beside {{ lining: '{}' ring_width: 1.5 {} }}", beside, dowels));
}

// Both are half as stiff and heavy as one ring alone, results are those of two metres of the plane, and the
// contacts with the ground are as long together as those of one.
TEST(Rings, HaveHalfOfThePlaneEach) {
  const Supports alone = resolved(first()), both = resolved(first() + second());
  ASSERT_EQ(both.linings.size(), 2u);
  EXPECT_EQ(alone.linings[0].spacing, 1);
  for (const Lining& ring : both.linings) {
    EXPECT_EQ(ring.spacing, 2);
    EXPECT_EQ(both.structures.beams()[ring.first_beam].end_mass(),
              alone.structures.beams()[0].end_mass() / 2);
  }
  EXPECT_EQ(both.contacts.size(), 2 * alone.contacts.size());
  for (const auto point : both.linings[1].path.points)
    EXPECT_FALSE(std::ranges::count(both.linings[0].path.points, point));
}

// In each metre of the plane is 1/1.5 of a dowel: it yields at 40 kN there.
TEST(Rings, HaveDowelsInEachWidth) {
  Supports supports = resolved(second() + first());  // in any order
  const Lining& ring = supports.linings[0];
  ASSERT_EQ(ring.dowels, std::vector<std::size_t>{2});
  EXPECT_EQ(ring.ring_width, 1.5);
  Dowel dowel = supports.structures.dowels()[0];
  EXPECT_EQ(dowel.points()[0], supports.linings[1].path.points[2]);
  EXPECT_EQ(dowel.points()[1], ring.path.points[2]);
  for (const StrainForm& form : dowel.strains()) EXPECT_NEAR(form.stiffness, 20e6, 1e-6);
}

// Along x until it yields, then along y: the force stays on its circle and turns towards the motion; what is
// taken up is what is stored and what is dissipated.
TEST(Dowels, YieldAlikeInEveryDirection) {
  constexpr double kStiffness = 2e7, kYield = 4e4;
  Dowel dowel({0, 1}, kStiffness, kYield);
  double taken = 0, dissipated = 0;
  std::array<double, 2> force{};
  const auto move = [&](double dx, double dy, int steps) {
    for (int n = 0; n < steps; ++n) {
      const std::array<double, 2> vx{0, dx}, vy{0, dy};
      std::array<double, 2> fx{}, fy{};
      const double lost = dowel.add_forces(1, {vx.data(), vy.data(), fx.data(), fy.data()});
      EXPECT_GE(lost, 0);
      EXPECT_EQ(fx[0], -fx[1]);
      EXPECT_LE(dowel.force(), kYield * (1 + 1e-12));
      dissipated += lost;
      taken += dx * (force[0] + fx[0]) / 2 + dy * (force[1] + fy[0]) / 2;
      force = {fx[0], fy[0]};
    }
  };
  move(1e-4, 0, 10);
  EXPECT_NEAR(dowel.force(), 2e4, 1e-6);
  EXPECT_EQ(dissipated, 0);
  move(1e-4, 0, 30);
  EXPECT_NEAR(dowel.force(), kYield, 1e-6);
  EXPECT_NEAR(dissipated, kYield * 2e-3, 1e-6);
  move(0, 1e-4, 200);
  EXPECT_NEAR(dowel.force(), kYield, 1e-6);
  EXPECT_NEAR(dowel.offset(), std::hypot(4e-3, 20e-3), 1e-12);
  EXPECT_NEAR(taken, dowel.strain_energy() + dissipated, 1e-9 * taken);
}

struct Case {
  std::string name, continuum, path, message;
};
void PrintTo(const Case& refused, std::ostream* out) {
  *out << refused.name;
}

class RingsError : public testing::TestWithParam<Case> {};

TEST_P(RingsError, NamesTheFieldAndTheRemedy) {
  adit::test::expect_refusal([] { resolved(GetParam().continuum); }, GetParam().path, GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, RingsError,
    testing::Values(
        Case{"unknown", first() + second("", kFriction, "second", "frist"),
             "continuum.linings[1].beside.lining",
             "is `frist`, which is no other lining; did you mean `first`?; name the ring that this one lies"},
        Case{"third", first() + second() + second("", kFriction, "third"),
             "continuum.linings[2].beside.lining",
             "is `first`, which is beside another ring already; two kinds of rings follow in turn"},
        Case{"tied", first("") + second(), "continuum.linings[1].beside",
             "joins rings of which `first` is tied to the ground, so that they cannot move apart; give both "
             "an `interface`"},
        Case{"layered", first() + second() + lining("inside", "on: 'second'"), "continuum.linings[1].beside",
             "joins rings on one of which, `second`, lies `inside`; leave that out, or the second ring"},
        Case{
            "own_path",
            first() + second("", kFriction + "along { line { points { x: 0 y: 1 } points { x: 6 y: 1 } } } "),
            "continuum.linings[1].along", "is given, but the ring follows `first`"},
        Case{"later", first() + second("", kFriction + "stage: 2 "), "continuum.linings[1].stage",
             "is 2, but the ring beside this one is installed in stage 0; give both the same"},
        Case{"twice", first() + second(kDowel + kDowel), "continuum.linings[1].beside.dowels[1]",
             "lies at the same node as dowels[0]; leave one out, or use shorter zones"},
        Case{"nowhere", first() + second("dowels { stiffness: 1e6 } "),
             "continuum.linings[1].beside.dowels[0]", "needs one place: give either `at` or `angle`"},
        Case{"member",
             first() + second() +
                 "members { name: 'prop' from { x: 3 y: 1 } to { x: 3 y: 2 } spacing: 1 thickness: 0.3 "
                 "young_modulus: 30e9 last_end_hinged: true } ",
             "continuum.members[0]",
             "ends at `second`, beside which lies another ring; let it end at a lining that stands alone"}),
    [](const auto& refused) { return refused.param.name; });

}  // namespace
}  // namespace adit::fdm::test::rings_test

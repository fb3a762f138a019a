// Requirements on the diameters of rings: those of an ellipse, whatever else the ring does.
#include "dem_server/lining/ovals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>

#include "dem_server/engines/general/general_engine.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/dem_server/discs_models.hpp"
#include "tests/unit/dem_server/in_process_run.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::ovals_test {
namespace {

using std::numbers::pi;

constexpr double kInner = 3, kOuter = 4, kDisc = 0.1;
constexpr geometry::Point kCentre{5, 6};

Model ring() {
  std::vector<std::array<double, 3>> discs;
  const int rows = static_cast<int>(2 * kOuter / (std::numbers::sqrt3 * kDisc)) + 2;
  for (int row = -rows; row <= rows; ++row)
    for (int k = -50; k <= 50; ++k) {
      const double x = (2 * k + row % 2) * kDisc, y = row * std::numbers::sqrt3 * kDisc, r = std::hypot(x, y);
      if (r >= kInner && r <= kOuter) discs.push_back({kCentre.x + x, kCentre.y + y, kDisc});
    }
  return test::loose_discs(discs, {1e8, 1e8, 0});
}

// The ring becomes an ellipse that is 3 mm longer at the angle and 1 mm shorter across, and it moves and
// turns.
void deform(Particles& p, double angle) {
  const double mean = kInner / 2 + kOuter / 2, longer = 3e-3 / (2 * mean), shorter = -1e-3 / (2 * mean);
  const double c = std::cos(angle), s = std::sin(angle);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double x = p.x[i] - kCentre.x, y = p.y[i] - kCentre.y;
    const double along = longer * (x * c + y * s), across = shorter * (y * c - x * s);
    p.ux[i] = p.settled_x[i] + 0.02 + along * c - across * s - 1e-2 * y;
    p.uy[i] = p.settled_y[i] - 0.05 + along * s + across * c + 1e-2 * x;
  }
}

Oval oval(const Particles& p) {
  return {"ring", kCentre, kInner, kOuter, p};
}

// Places of discs in a sector are uneven, which costs about a hundredth.
void expect_ellipse(const DiameterChange& change, double angle) {
  EXPECT_NEAR(change.largest, 3e-3, 0.015 * 3e-3);
  EXPECT_NEAR(change.smallest, -1e-3, 0.015 * 3e-3);
  EXPECT_NEAR(std::remainder(change.direction - angle, pi), 0, pi / 180);
}

TEST(Ovals, TellTheDiametersOfAnEllipse) {
  GeneralEngine engine(ring(), 1);
  Particles& p = engine.particles();
  p.settled_x.assign(p.size(), 0.3);  // displacements count from here
  for (const double angle : {0.3, 1.2, -0.7, pi / 2}) {
    deform(p, angle);
    expect_ellipse(oval(p).change(p), angle);
  }
}

// Grains that fell off say nothing of the ring.
TEST(Ovals, DoNotFollowLooseGrains) {
  GeneralEngine engine(ring(), 1);
  Particles& p = engine.particles();
  deform(p, 0.3);
  for (std::size_t i = 0; i < p.size(); i += 50) p.uy[i] -= 2;
  expect_ellipse(oval(p).change(p), 0.3);
}

// Requirement: a ring and its mirror image have the same diameters, also where particles lie between two
// sectors, as on the axes.
TEST(Ovals, AreMirroredWithTheirRing) {
  GeneralEngine engine(ring(), 1);
  Particles& p = engine.particles();
  for (const double outer : {3.4, 3.55, 3.7, 3.85, 4.0}) {  // rings of other numbers of sectors
    const Oval observed("ring", kCentre, kInner, outer, p);
    const auto deformed = [&](double sign_x, double sign_y) {
      for (std::size_t i = 0; i < p.size(); ++i) {
        const double x = sign_x * (p.x[i] - kCentre.x), y = sign_y * (p.y[i] - kCentre.y);
        p.ux[i] = p.settled_x[i] + sign_x * 1e-3 * (std::sin(3 * x + y) + x * y);
        p.uy[i] = p.settled_y[i] + sign_y * 1e-3 * (std::cos(2 * y - x) + y);
      }
      return observed.change(p);
    };
    const DiameterChange one = deformed(1, 1);
    for (const DiameterChange& other : {deformed(1, -1), deformed(-1, 1)}) {
      EXPECT_NEAR(one.largest, other.largest, 1e-12) << outer;
      EXPECT_NEAR(one.smallest, other.smallest, 1e-12) << outer;
      EXPECT_NEAR(std::remainder(one.direction + other.direction, pi), 0, 1e-9) << outer;
    }
  }
}

TEST(Ovals, AreUnknownWithoutTheirParticles) {
  GeneralEngine engine(ring(), 1);
  Particles& p = engine.particles();
  const Oval whole = oval(p);
  EXPECT_TRUE(whole.is_whole());
  EXPECT_FALSE(Oval("half", {kCentre.x + kOuter, kCentre.y}, kInner, kOuter, p).is_whole());
}

// Each extreme comes with the time at which it was reached first, and with the direction of that diameter.
TEST(Ovals, EnvelopeKeepsTheExtremes) {
  OvalEnvelope envelope;
  EXPECT_TRUE(envelope.largest().empty());
  envelope.take(std::vector<DiameterChange>{{2, -1, 0.1}}, 0.1);
  envelope.take(std::vector<DiameterChange>{{1, -4, 0.5}}, 0.2);
  envelope.take(std::vector<DiameterChange>{{2, -3, -0.2}}, 0.3);
  EXPECT_EQ(envelope.largest()[0].value, 2);
  EXPECT_EQ(envelope.largest()[0].time, 0.1);
  EXPECT_EQ(envelope.largest()[0].direction, 0.1);
  EXPECT_EQ(envelope.smallest()[0].value, -4);
  EXPECT_EQ(envelope.smallest()[0].time, 0.2);
  EXPECT_EQ(envelope.smallest()[0].direction, 0.5 - pi / 2);
}

// A ring that is pulled to the right and to the left.
scene::Scene pulled_ring() {
  auto scene = test::empty_scene();
  auto& particles = *scene.mutable_particles();
  auto& packing = *particles.mutable_packing();
  test::set_box(packing, 10, 10);
  packing.set_radius(0.2);
  auto& annulus = *particles.mutable_within()->mutable_annulus();
  test::set(*annulus.mutable_centre(), 5, 5);
  annulus.set_inner_radius(kInner);
  annulus.set_outer_radius(kOuter);
  auto& oval = *particles.add_ovals();
  oval.set_name("ring");
  *oval.mutable_annulus() = annulus;
  for (const auto quantity :
       {scene::LARGEST_DIAMETER_CHANGE, scene::SMALLEST_DIAMETER_CHANGE, scene::LARGEST_DIAMETER_DIRECTION}) {
    auto& history = *particles.add_histories();
    history.set_name("ring");
    history.set_oval("ring");
    history.set_quantity(quantity);
  }
  auto& pull = *particles.add_loads();
  pull.mutable_where()->set_x_min(8.5);
  pull.mutable_force()->set_x(1e6);
  auto& other = *particles.add_loads();
  other.mutable_where()->set_x_max(1.5);
  other.mutable_force()->set_x(-1e6);
  return scene;
}

// Requirement: a ring that is pulled apart along x grows there and shrinks across, in its histories and in
// the figures at the end, which hold the largest of all times.
TEST(Ovals, AreToldByHistoriesAndAtTheEnd) {
  test::InProcessRun run(pulled_ring(), {}, 0.5);
  double largest = 0, smallest = 0;
  for (int n = 0; n < 60; ++n) {
    run.advance();
    const auto& values = run.predicted.histories();
    ASSERT_EQ(values.size(), 3);
    largest = std::max(largest, values[0]);
    smallest = std::min(smallest, values[1]);
  }
  EXPECT_GT(largest, 0);
  EXPECT_LT(smallest, 0);
  EXPECT_NEAR(run.predicted.histories(2), 0, 0.05);
  wire::Bye bye;
  run.participant.finish(bye);
  std::map<std::string, double> figures;
  for (const auto& figure : bye.figures()) figures[figure.name()] = figure.value();
  EXPECT_EQ(figures.at("ovals_largest_diameter_change_m"), largest);
  EXPECT_EQ(figures.at("ovals_smallest_diameter_change_m"), smallest);
  EXPECT_NEAR(std::abs(figures.at("ovals_smallest_diameter_change_direction_rad")), pi / 2, 0.05);
  EXPECT_EQ(figures.at("ovals_largest_diameter_change_x_m"), 5);
  EXPECT_GT(figures.at("ovals_largest_diameter_change_time_s"), 0);
}

using Case = adit::test::Refusal<std::function<void(scene::Particles&)>>;
class OvalErrors : public testing::TestWithParam<Case> {};

TEST_P(OvalErrors, NameTheFieldAndTheRemedy) {
  auto scene = pulled_ring();
  GetParam().input(*scene.mutable_particles());
  adit::test::expect_refusal([&] { test::InProcessRun run(scene); }, "particles." + GetParam().path,
                             GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    All, OvalErrors,
    testing::Values(Case{"Twice", "ovals[1].name", "is `ring`, like that of an earlier oval",
                         [](auto& p) { *p.add_ovals() = p.ovals(0); }},
                    Case{"Gaps", "ovals[0].annulus", "has gaps without particles",
                         [](auto& p) { p.mutable_ovals(0)->mutable_annulus()->mutable_centre()->set_x(8); }},
                    Case{"NoSuchOval", "histories[0].oval", "choose one of ring",
                         [](auto& p) { p.mutable_histories(0)->set_oval("rung"); }}),
    adit::test::kRefusalName);

}  // namespace
}  // namespace adit::dem::ovals_test

// Requirements on linings that meet: joined rigidly, or by the joints that stand there.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "fdm_server/supports/peak_forces.hpp"
#include "tests/unit/fdm_server/structures/frames.hpp"

namespace adit::fdm::test::meetings_test {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity(), kForce = 1e5;
using Points = std::vector<std::uint32_t>;

struct Part {
  Points points;
  std::vector<LiningJoint> joints = {};
  std::array<bool, 2> held = {};
  bool closed = false;
  std::uint32_t stage = 0;
};

// Linings of one section, without ground.
struct Frames {
  Grid grid;
  Structures structures{};
  std::vector<Lining> linings{};

  Frames(Grid points, const std::vector<Part>& parts, bool shear_flexible = true) : grid(std::move(points)) {
    for (const Part& part : parts) {
      structures.set_stage(part.stage);
      linings.push_back(add_lining({"lining",
                                    {part.points, part.closed},
                                    wall(0.4, shear_flexible),
                                    part.joints,
                                    part.held[0],
                                    part.held[1]},
                                   grid, structures));
    }
  }
  // Points that bear nothing yet have a mass, too.
  std::vector<double> masses(std::uint32_t stage = 0) const {
    std::vector<double> masses(grid.x.size(), 1.0);
    structures.add_masses(masses, stage);
    return masses;
  }
  Continuum continuum(std::vector<Load> loads, std::vector<PrescribedMotion> motions = {}) const {
    return beams_alone(grid, structures, masses(), std::move(loads), std::move(motions));
  }
};

Points range(std::uint32_t first, std::uint32_t last) {
  Points points(last - first + 1);
  std::iota(points.begin(), points.end(), first);
  return points;
}

Part reversed(Part part) {
  std::ranges::reverse(part.points);
  for (LiningJoint& joint : part.joints) joint.node = part.points.size() - 1 - joint.node;
  return part;
}

// A square of 4 m, eight beams a side, counter-clockwise from its right corner at the bottom.
constexpr std::uint32_t kSide = 8;
Grid square() {
  Grid grid;
  for (std::uint32_t k = 0; k < 4 * kSide; ++k) {
    const double s = 4.0 * (k % kSide) / kSide - 2;
    const std::array<double, 2> places[] = {{2, s}, {-s, 2}, {-2, -s}, {s, -2}};
    grid.x.push_back(places[k / kSide][0]);
    grid.y.push_back(places[k / kSide][1]);
  }
  return grid;
}
Part closed_square() {
  return {range(0, 4 * kSide - 1), {}, {}, true};
}
std::vector<Part> four_sides() {
  std::vector<Part> sides;
  for (std::uint32_t side = 0; side < 4; ++side) {
    Part& part = sides.emplace_back(Part{range(kSide * side, kSide * (side + 1))});
    part.points.back() %= 4 * kSide;
  }
  return sides;
}

// A force on the middle of one side, against others on the corners; not in balance, so that it moves, too.
Load blow() {
  return {{kSide / 2, kSide, 2 * kSide}, {-kForce, 0.3 * kForce, 0.2 * kForce}, {0, 2e4, -5e4}, constant};
}

struct Motion {
  std::vector<double> ux, uy;
  double corner_moment;  // at the end of the first side
};
// After 3000 steps, which are longer than the beams' own where `long_steps`.
Motion moved(const std::vector<Part>& parts, bool long_steps, std::size_t side = 0) {
  const Frames frames(square(), parts);
  Continuum continuum = frames.continuum({blow()});
  const double dt = (long_steps ? 3 : 0.9) * frames.structures.critical_step();
  for (std::uint64_t n = 0; n < 3000; ++n) continuum.step({n, dt});
  const Beam& last = continuum.structures().beams()[frames.linings[side].first_beam + kSide - 1];
  return {{continuum.ux().begin(), continuum.ux().end()},
          {continuum.uy().begin(), continuum.uy().end()},
          last.forces().second};
}
void expect_equal(const Motion& a, const Motion& b) {
  double largest = 0;
  for (const auto* values : {&a.ux, &a.uy})
    for (const double u : *values) largest = std::max(largest, std::abs(u));
  for (std::size_t i = 0; i < a.ux.size(); ++i) {
    ASSERT_NEAR(a.ux[i], b.ux[i], 1e-9 * largest);
    ASSERT_NEAR(a.uy[i], b.uy[i], 1e-9 * largest);
  }
  EXPECT_NEAR(a.corner_moment, b.corner_moment, 1e-7 * kForce);
}

// A frame of four linings moves as that of one closed lining, whatever their order and directions.
TEST(LiningMeetings, FourSidesAreOneClosedFrame) {
  for (const bool long_steps : {false, true}) {
    const Motion one = moved({closed_square()}, long_steps);
    EXPECT_GE(std::abs(one.corner_moment), 0.01 * kForce);
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    do {
      std::vector<Part> parts;
      for (const auto side : order) parts.push_back(four_sides()[side]);
      const auto first = static_cast<std::size_t>(std::ranges::find(order, 0u) - order.begin());
      expect_equal(one, moved(parts, long_steps, first));
    } while (std::ranges::next_permutation(order).found && !long_steps);
    auto parts = four_sides();
    parts[1] = reversed(parts[1]);
    parts[3] = reversed(parts[3]);
    expect_equal(one, moved(parts, long_steps));
  }
}

// A joint at the end of a lining, first or last, is that of the closed lining at this corner: hinge, spring,
// yield moment.
TEST(LiningMeetings, AJointAtAnEndStandsBetweenTheLinings) {
  const double stiffness = wall(0.4).bending;
  for (const auto& [k, yield] : {std::pair{0.0, kInf}, {stiffness, kInf}, {stiffness, 2e3}}) {
    Part closed = closed_square();
    closed.joints = {{kSide, k, yield}};
    auto of_first = four_sides(), of_second = of_first;
    of_first[0].joints = {{kSide, k, yield}};
    of_second[1].joints = {{0, k, yield}};
    const Motion one = moved({closed}, false);
    expect_equal(one, moved(of_first, false));
    expect_equal(one, moved(of_second, false));
  }
}

// Hinges at both of two ends are a hinge.
TEST(LiningMeetings, AllEndsMayBeHinged) {
  auto one = four_sides(), both = one;
  one[0].joints = both[0].joints = {{kSide, 0, kInf}};
  both[1].joints = {{0, 0, kInf}};
  expect_equal(moved(one, false), moved(both, false));
}

// A circle written as two arcs is the circle; so is a lining whose two ends are one point.
TEST(LiningMeetings, TwoArcsAreACircle) {
  constexpr std::uint32_t kBeams = 24;
  const auto moved = [](const std::vector<Part>& parts) {
    const Frames frames(circle(3, kBeams), parts);
    Continuum continuum = frames.continuum({{{0, 10}, {kForce, -kForce}, {0, 2e4}, constant}});
    const double dt = 0.9 * frames.structures.critical_step();
    for (std::uint64_t n = 0; n < 3000; ++n) continuum.step({n, dt});
    return std::vector(continuum.ux().begin(), continuum.ux().end());
  };
  Part upper{range(0, kBeams / 2)}, lower{range(kBeams / 2, kBeams)}, around{range(0, kBeams)};
  lower.points.back() = around.points.back() = 0;
  const auto whole = moved({{range(0, kBeams - 1), {}, {}, true}});
  const double scale = std::abs(*std::ranges::max_element(whole, {}, [](double u) { return std::abs(u); }));
  for (const auto& parts : {std::vector{upper, lower}, {around}}) {
    const auto found = moved(parts);
    for (std::size_t i = 0; i < kBeams; ++i) EXPECT_NEAR(found[i], whole[i], 1e-9 * scale);
  }
}

// At the corner of a bracket, a post with an arm, the post bears the load as thrust and the arm as shear
// force, and neither bears the mean; the moment is that of both. Whatever the direction of the path.
TEST(LiningMeetings, ACornerTellsWhatEachSideBears) {
  Grid bracket;
  for (int k = 0; k <= 4; ++k) bracket.x.push_back(0), bracket.y.push_back(0.5 * k);
  for (int k = 1; k <= 4; ++k) bracket.x.push_back(0.5 * k), bracket.y.push_back(2);
  const Part upwards{range(0, 8), {}, {true, false}};
  for (const Part& part : {upwards, reversed({range(0, 8), {}, {false, true}})}) {
    const Frames frames(bracket, {part}, false);
    Continuum continuum =
        frames.continuum({{{8}, {0}, {-kForce}, constant}}, {fixed({0}, Axis::kX), fixed({0}, Axis::kY)});
    settle(continuum, 0.9 * frames.structures.critical_step());
    const auto all = all_forces_at(frames.linings[0], continuum.structures(), 4);
    ASSERT_EQ(all.count, 2u);
    const bool post_first = part.points.front() == 0;
    const LiningForces &post = all.forces[post_first ? 0 : 1], &arm = all.forces[post_first ? 1 : 0];
    EXPECT_NEAR(post.thrust, -kForce, 1e-8 * kForce);
    EXPECT_NEAR(post.shear, 0, 1e-8 * kForce);
    EXPECT_NEAR(arm.thrust, 0, 1e-8 * kForce);
    EXPECT_NEAR(std::abs(arm.shear), kForce, 1e-8 * kForce);
    EXPECT_NEAR(std::abs(post.moment), 2 * kForce, 1e-8 * kForce);
    EXPECT_NEAR(post.moment, arm.moment, 1e-8 * kForce);
    EXPECT_EQ(forces_at(frames.linings[0], continuum.structures(), 4).thrust, post.thrust);
    PeakForces peaks;
    peaks.take(frames.linings, continuum.structures(), 1);
    EXPECT_EQ(peaks.thrust().least[4].thrust, post.thrust);
    EXPECT_EQ(peaks.thrust().largest[4].thrust, arm.thrust) << "the other side of the corner counts, too";
    EXPECT_EQ(all_forces_at(frames.linings[0], continuum.structures(), 2).count, 1u);
  }
}

// A slab of two spans over a column that ends at its middle D, all other ends built in: slope-deflection.
//
//   A ---- P ---- D -------- B       D does not move but turns, by theta = (P l_1/8)/(4 EI sum 1/l).
//                 |
//                 C                  A member turned at one end bears 4 EI theta/l there, 2 EI theta/l at
//                                    the other.
constexpr double kLeft = 4, kRight = 6, kHeight = 3;
constexpr std::uint32_t kA = 0, kD = 8, kB = 16, kC = 24;
Grid tee() {
  Grid grid;
  for (int k = 0; k <= 8; ++k) grid.x.push_back(kLeft * k / 8), grid.y.push_back(0);
  for (int k = 1; k <= 8; ++k) grid.x.push_back(kLeft + kRight * k / 8), grid.y.push_back(0);
  for (int k = 1; k <= 8; ++k) grid.x.push_back(kLeft), grid.y.push_back(-kHeight * k / 8);
  return grid;
}
Part slab() {
  return {range(kA, kB), {}, {true, true}};
}
Part column(std::vector<LiningJoint> joints = {}, std::uint32_t stage = 0) {
  Points points = range(kB, kC);
  points.front() = kD;
  return {std::move(points), std::move(joints), {false, true}, false, stage};
}
std::vector<PrescribedMotion> built_in() {
  return {fixed({kA, kD, kB, kC}, Axis::kX), fixed({kA, kD, kB, kC}, Axis::kY)};
}
Load on_the_left_span(double factor = 1) {
  return {{4}, {0}, {-kForce}, [factor](double /*t*/) { return factor; }};
}

struct Column {
  double top, foot;  // moments of the column
  double slab_at_a;
};
Column column_of(const Frames& frames, const Continuum& continuum, std::size_t slab, std::size_t column) {
  const auto at = [&](std::size_t lining, std::size_t node) {
    return forces_at(frames.linings[lining], continuum.structures(), node).moment;
  };
  return {at(column, 0), at(column, 8), at(slab, 0)};
}

// With what the column bears at its top for a turn of 1 [N m/rad].
void expect_slope_deflection(const Column& found, double stiffness_of_column) {
  const double bending = wall(0.4, false).bending, fixed_end = kForce * kLeft / 8;
  const double theta = fixed_end / (4 * bending * (1 / kLeft + 1 / kRight) + stiffness_of_column);
  EXPECT_NEAR(found.top, -stiffness_of_column * theta, 1e-8 * fixed_end);
  EXPECT_NEAR(found.foot, stiffness_of_column * theta / 2, 1e-8 * fixed_end);
  EXPECT_NEAR(found.slab_at_a, -fixed_end - 2 * bending * theta / kLeft, 1e-8 * fixed_end);
}

// The end of one lining on the middle of another is joined rigidly; a joint at the end acts behind the
// column, 1/(1/k + l/4 EI), and a hinge frees it.
TEST(LiningMeetings, ATFrameFollowsSlopeDeflection) {
  const double bending = wall(0.4, false).bending, whole = 4 * bending / kHeight, spring = 0.6 * whole;
  const std::pair<std::vector<LiningJoint>, double> cases[] = {
      {{}, whole}, {{{0, spring, kInf}}, 1 / (1 / spring + 1 / whole)}, {{{0, 0, kInf}}, 0}};
  for (const auto& [joints, stiffness] : cases)
    for (const bool slab_first : {true, false}) {
      std::vector<Part> parts{slab(), column(joints)};
      if (!slab_first) std::ranges::reverse(parts);
      const Frames frames(tee(), parts, false);
      Continuum continuum = frames.continuum({on_the_left_span()}, built_in());
      settle(continuum, 0.9 * frames.structures.critical_step());
      expect_slope_deflection(column_of(frames, continuum, slab_first ? 0 : 1, slab_first ? 1 : 0),
                              stiffness);
    }
}

// Where every end has a joint, they act one after the other: here two of 2 k as one of k.
TEST(LiningMeetings, TwoJointsActOneAfterTheOther) {
  const double k = wall(0.4, false).bending;
  const auto column_with = [&](const std::vector<LiningJoint>& of_span,
                               const std::vector<LiningJoint>& of_column) {
    const Frames frames(tee(), {{range(kA, kD), of_span, {true, false}}, column(of_column)}, false);
    Continuum continuum = frames.continuum({on_the_left_span()}, built_in());
    settle(continuum, 0.9 * frames.structures.critical_step());
    return column_of(frames, continuum, 0, 1);
  };
  const Column one = column_with({{8, k, kInf}}, {}),
               two = column_with({{8, 2 * k, kInf}}, {{0, 2 * k, kInf}});
  EXPECT_GE(std::abs(one.top), 0.01 * kForce);
  EXPECT_NEAR(two.top, one.top, 1e-8 * kForce);
  EXPECT_NEAR(two.foot, one.foot, 1e-8 * kForce);
}

// A column of a later stage changes nothing before, inertia included, is installed free of stress, and then
// bears its share of what is added; wherever it is listed.
TEST(LiningMeetings, ALaterLiningJoinsTheRotationThatIsThere) {
  const double whole = 4 * wall(0.4, false).bending / kHeight;
  for (const bool slab_first : {true, false}) {
    std::vector<Part> parts{slab(), column({}, 1)};
    if (!slab_first) std::ranges::reverse(parts);
    const Frames alone(tee(), {slab()}, false), frames(tee(), parts, false);
    const double dt = 0.9 * frames.structures.critical_step();
    Continuum before = alone.continuum({on_the_left_span()}, built_in()),
              continuum = frames.continuum({on_the_left_span()}, built_in());
    for (std::uint64_t n = 0; n < 500; ++n) {
      before.step({n, dt});
      continuum.step({n, dt});
    }
    EXPECT_TRUE(std::ranges::equal(before.uy(), continuum.uy()));

    const std::size_t of_slab = slab_first ? 0 : 1, of_column = 1 - of_slab;
    settle(continuum, dt);
    continuum.stop();
    const Column at_first = column_of(frames, continuum, of_slab, of_column);
    EXPECT_EQ(at_first.top, 0);
    continuum.excavate({}, frames.masses(1), {on_the_left_span()}, 1);
    settle(continuum, dt);
    EXPECT_NEAR(column_of(frames, continuum, of_slab, of_column).top, 0, 1e-8 * kForce);
    continuum.excavate({}, frames.masses(1), {on_the_left_span(2)}, 1);
    settle(continuum, dt);
    const Column at_last = column_of(frames, continuum, of_slab, of_column);
    expect_slope_deflection({at_last.top, at_last.foot, at_last.slab_at_a - at_first.slab_at_a}, whole);
  }
}

// An end that a later lining holds turns freely until then.
TEST(LiningMeetings, ALaterFixedEndHoldsFromItsStageOn) {
  Part later = column({}, 1);
  later.held = {true, false};
  const Frames frames(tee(), {slab(), later}, false);
  Continuum continuum = frames.continuum({on_the_left_span()}, built_in());
  const double dt = 0.9 * frames.structures.critical_step();
  settle(continuum, dt);
  continuum.stop();
  const double turned = continuum.structures().rotations()[kD];
  EXPECT_GT(turned, 0);
  continuum.excavate({}, frames.masses(1), {on_the_left_span(2)}, 1);
  settle(continuum, dt);
  EXPECT_NEAR(continuum.structures().rotations()[kD], turned, 1e-8 * turned);
}

}  // namespace
}  // namespace adit::fdm::test::meetings_test

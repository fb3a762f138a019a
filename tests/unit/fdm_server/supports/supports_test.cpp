// Requirements on linings and bolts of a scene: the edges that they follow, and every error with its remedy.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "fdm_server/grid/edges.hpp"
#include "fdm_server/model/supports/supports.hpp"
#include "protocol/errors.hpp"
#include "protocol/scene/fields/check_rules.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/fdm_server/scenes.hpp"
#include "tests/unit/fdm_server/structures/frames.hpp"

namespace adit::fdm::test::supports_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

scene::Scene parsed(const std::string& continuum) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString("continuum { " + continuum + " }", &scene))
      << continuum;
  return scene;
}

// A block of 6 x 3 zones of 1 m, points counted row by row: 7 in a row.
Grid block_grid() {
  const Block block{0, 6, 0, 3, 6, 3};
  return make_grid(block);
}

// Two rings of eight zones between radii of 1, 2 and 3 m, the inner wall being the boundary.
Grid ring_grid() {
  Grid grid;
  for (const double radius : {1.0, 2.0, 3.0}) {
    const Grid ring = circle(radius, 8);
    grid.x.insert(grid.x.end(), ring.x.begin(), ring.x.end());
    grid.y.insert(grid.y.end(), ring.y.begin(), ring.y.end());
  }
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 8; ++i) {
      const int next = (i + 1) % 8;
      grid.zones.push_back({8 * j + i, 8 * j + 8 + i, 8 * j + 8 + next, 8 * j + next});
    }
  grid.boundary = boundary(number_edges(grid));
  return grid;
}

const std::string kConcreteWall = "thickness: 0.3 young_modulus: 30e9 ";

Supports with(const std::string& text, const Grid& grid) {
  const scene::Scene scene = parsed(text);
  protocol::check_rules(scene.continuum(), "continuum");
  Grid own = grid;
  return resolve_supports(scene, Ground{}, {}, own);
}
std::vector<std::uint32_t> path_of(const std::string& along, const Grid& grid) {
  return with("linings { name: 'l' along { " + along + " } " + kConcreteWall + "}", grid)
      .linings.at(0)
      .path.points;
}

TEST(SupportsPath, ALineFollowsTheEdgesThroughItsCorners) {
  EXPECT_THAT(
      path_of("line { points { x: 1 y: 1 } points { x: 4 y: 1 } points { x: 4 y: 3 } }", block_grid()),
      ElementsAre(8, 9, 10, 11, 18, 25));
}

// A point beside the line, but nearer than a twentieth of its edge, belongs to it.
TEST(SupportsPath, ALineMayLieSlightlyBesideThePoints) {
  Grid grid = block_grid();
  grid.y[9] += 0.04;
  const std::string line = "line { points { x: 1 y: 1 } points { x: 3 y: 1 } }";
  EXPECT_THAT(path_of(line, grid), ElementsAre(8, 9, 10));
  grid.y[9] += 0.1;
  EXPECT_THROW(path_of(line, grid), protocol::UserError);
}

TEST(SupportsPath, ACircleIsClosedAndCounterClockwise) {
  const auto supports =
      with("linings { name: 'l' along { circle { centre { x: 0 y: 0 } radius: 2 } } " + kConcreteWall + "}",
           ring_grid());
  EXPECT_TRUE(supports.linings[0].path.closed);
  EXPECT_THAT(supports.linings[0].path.points, ElementsAre(8, 9, 10, 11, 12, 13, 14, 15));
  EXPECT_EQ(supports.linings[0].beams, 8u);
}

TEST(SupportsPath, AnArcMayPassTheAngleZero) {
  EXPECT_THAT(
      path_of("circle { centre { x: 0 y: 0 } radius: 2 from: -1.5707963 to: 1.5707963 }", ring_grid()),
      ElementsAre(14, 15, 8, 9, 10));
}

// The wall of a hole is rounded counter-clockwise, with the ground on the right.
TEST(SupportsPath, AWallHasTheGroundOnItsRight) {
  auto points = path_of("wall { circle { centre { x: 0 y: 0 } radius: 1.1 } }", ring_grid());
  ASSERT_EQ(points.size(), 8u);
  std::rotate(points.begin(), std::ranges::find(points, 0u), points.end());
  EXPECT_THAT(points, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
}

TEST(SupportsPath, ASideOfABlockIsAWallToo) {
  Grid grid = block_grid();
  grid.boundary = boundary(number_edges(grid));
  EXPECT_THAT(path_of("wall { y_min: 3 x_min: 2 x_max: 5 }", grid), ElementsAre(23, 24, 25, 26));
}

TEST(SupportsPath, AWallThatBranchesIsRefusedWithItsPlace) {
  Grid grid = block_grid();
  grid.boundary = boundary(number_edges(grid));
  grid.boundary.push_back({24, 17, 0});
  adit::test::expect_refusal([&] { path_of("wall { y_min: 2 x_min: 2 x_max: 5 }", grid); },
                             "continuum.linings[0].along.wall", "holds edges that branch at (3, 3) m");
}

// Joints go to the nearest node, by place or by angle.
TEST(Supports, JointsAreHinges) {
  const std::string circle = "linings { name: 'l' along { circle { centre { x: 0 y: 0 } radius: 2 } } ";
  const auto supports =
      with(circle + kConcreteWall + "joints { angle: 0.1 } joints { at { x: -1.9 y: 0.1 } } }", ring_grid());
  EXPECT_EQ(supports.structures.rotations().size(), 10u);
}

// A hinged column leaves the joint of the slab above it between the slab's beams.
TEST(Supports, AHingedLiningMayEndAtAJoint) {
  const std::string line = " along { line { points { x: 2 y: 1 } points { x: 2 y: 3 } } } " + kConcreteWall;
  const auto supports = with(
      "linings { name: 'slab' along { line { points { x: 1 y: 1 } points { x: 4 y: 1 } } } " + kConcreteWall +
          "joints { at { x: 2 y: 1 } } } linings { name: 'column'" + line + "joints { at { x: 2 y: 1 } } }",
      block_grid());
  EXPECT_EQ(supports.structures.rotations().size(), 4u + 1u + 2u + 1u);
}

// The user is told which linings are joined rigidly, and where; of several places of the same linings in one
// sentence, and nothing of linings that do not meet or are hinged.
TEST(Supports, TellsWhichLiningsAreJoined) {
  const auto along = [](const std::string& name, const std::string& from, const std::string& to,
                        const std::string& more = "") {
    return "linings { name: '" + name + "' along { line { points { " + from + " } points { " + to +
           " } } } " + kConcreteWall + more + "} ";
  };
  const std::string roof = along("roof", "x: 0 y: 1", "x: 6 y: 1"),
                    left = along("left", "x: 0 y: 1", "x: 0 y: 0"),
                    floor = along("floor", "x: 0 y: 0", "x: 6 y: 0"),
                    right = along("right", "x: 6 y: 0", "x: 6 y: 1", "joints { at { x: 6 y: 0 } } "),
                    post = along("post", "x: 3 y: 0", "x: 3 y: 0.5");
  EXPECT_THAT(Conversation(roof + left + floor + right).model.notes(),
              ElementsAre("the linings `roof` and `left` are joined rigidly at (0, 1) m",
                          "the linings `roof` and `right` are joined rigidly at (6, 1) m",
                          "the linings `left` and `floor` are joined rigidly at (0, 0) m"));
  EXPECT_THAT(Conversation(roof + post).model.notes(), ElementsAre());
  const std::string upper =
                        "linings { name: 'upper' along { line { points { x: 0 y: 0.5 } points { x: 0 y: 1 } "
                        "points { x: 6 y: 1 } points { x: 6 y: 0.5 } } } " +
                        kConcreteWall + "} ",
                    middle = along("middle", "x: 0 y: 0.5", "x: 6 y: 0.5");
  EXPECT_THAT(Conversation(upper + middle + post).model.notes(),
              ElementsAre("the linings `upper` and `middle` are joined rigidly at (0, 0.5) and (6, 0.5) m",
                          "the linings `middle` and `post` are joined rigidly at (3, 0.5) m"));
}

// A bolt's bars share its thrust; spacing divides area and strength.
TEST(Supports, BoltsAreSpreadOverTheirSpacing) {
  const auto supports =
      with("bolts { from { x: 1 y: 1 } to { x: 4 y: 1 } area: 6e-4 spacing: 1.5 young_modulus: 200e9 }",
           block_grid());
  ASSERT_EQ(supports.structures.bars().size(), 3u);
  EXPECT_THAT(supports.bolts[0].path.points, ElementsAre(8, 9, 10, 11));
  std::vector<double> masses(28, 0.0);
  supports.structures.add_masses(masses);
  EXPECT_NEAR(masses[9], 7850 * 4e-4, 1e-12);
  const double wave = 1 / std::sqrt(200e9 / 7850);
  EXPECT_NEAR(supports.structures.critical_step(), wave, 1e-12 * wave);
}

// Twice the bolt at twice the distance is the same ground, whose bolts bear twice the thrust each.
TEST(Supports, ThrustIsThatOfOneBolt) {
  const auto drawn = [](int times) {
    Conversation run(
        fmt::format("motions {{ where {{ y_max: 0 }} velocity {{ x: 0 y: 0 }} }} body_loads {{ acceleration "
                    "{{ y: -10 }} }} "
                    "bolts {{ from {{ x: 3 y: 0 }} to {{ x: 3 y: 1 }} area: {} spacing: {} }} ",
                    1e-3 * times, 1.0 * times));
    for (std::uint64_t n = 0; n <= 200; ++n) run.advance(n, run.model.critical_dt() / 2);
    wire::Snapshot snapshot;
    run.participant.snapshot({}, snapshot);
    return snapshot;
  };
  const wire::Snapshot one = drawn(1), two = drawn(2);
  ASSERT_EQ(one.pieces_size(), 2);
  ASSERT_EQ(one.pieces(1).name(), "bolts");
  const auto &moved = one.pieces(0).point_fields(0), &thrust = one.pieces(1).cell_fields(0);
  for (int i = 0; i < moved.values_size(); ++i)
    EXPECT_EQ(two.pieces(0).point_fields(0).values(i), moved.values(i));
  ASSERT_EQ(thrust.values_size(), 4);
  for (int i = 0; i < thrust.values_size(); ++i) {
    EXPECT_LT(thrust.values(i), 0);
    EXPECT_EQ(two.pieces(1).cell_fields(0).values(i), 2 * thrust.values(i));
  }
}

// The participant's step is that of its stiffest part, and its points carry the lining's mass.
TEST(Supports, TheLiningGovernsTheStep) {
  const std::string stiff =
      "linings { name: 'l' along { line { points { x: 1 y: 0.5 } points { x: 5 y: 0.5 } } } "
      "thickness: 0.3 young_modulus: 100e9 poisson_ratio: 0 density: 1000 } ";
  const Conversation without(""), with_lining(stiff);
  EXPECT_NEAR(with_lining.model.critical_dt(), 0.5 / std::sqrt(100e9 / 1000), 1e-12);
  EXPECT_GT(without.model.critical_dt(), with_lining.model.critical_dt());
}

// Histories of a lining's forces and its piece of a snapshot: a beam under its own weight on a rigid base.
TEST(Supports, ForcesAreRecordedAndDrawn) {
  const std::string scene =
      "motions { where { y_max: 0 } velocity { x: 0 y: 0 } } body_loads { acceleration { y: -10 } } "
      "linings { name: 'top' along { line { points { x: 0 y: 1 } points { x: 6 y: 1 } } } "
      "thickness: 0.5 young_modulus: 30e9 } "
      "bolts { from { x: 3 y: 0 } to { x: 3 y: 1 } area: 1e-3 spacing: 2 } "
      "histories { name: 'm' quantity: MOMENT at { x: 2.9 y: 1 } lining: 'top' } "
      "histories { name: 'u' quantity: DISPLACEMENT_Y at { x: 3 y: 1 } } "
      "histories { name: 'n' quantity: THRUST at { x: 3 y: 1 } lining: 'top' } "
      "histories { name: 'q' quantity: SHEAR_FORCE at { x: 1 y: 1 } lining: 'top' } ";
  Conversation run(scene);
  const double dt = 0.5 * run.model.critical_dt();
  for (std::uint64_t n = 0; n <= 400; ++n) run.advance(n, dt);
  const auto& rows = run.predicted.histories();
  ASSERT_EQ(rows.size(), 4);
  wire::Snapshot snapshot;
  run.participant.snapshot({}, snapshot);
  ASSERT_EQ(snapshot.pieces_size(), 3);
  const auto &lining = snapshot.pieces(1), &bolt = snapshot.pieces(2);
  EXPECT_EQ(lining.name(), "linings");
  EXPECT_EQ(lining.points_size(), 26);
  EXPECT_EQ(lining.connectivity_size(), 24);
  const auto field = [](const auto& fields, const std::string& name) {
    const auto found = std::ranges::find(fields, name, &wire::Field::name);
    EXPECT_NE(found, fields.end()) << name;
    return found->values();
  };
  const auto moment = field(lining.point_fields(), "moment_Nm");
  EXPECT_NE(rows[0], 0);
  EXPECT_EQ(moment[6], rows[0]);
  EXPECT_EQ(field(lining.point_fields(), "displacement_m")[3 * 6 + 1], rows[1]);
  EXPECT_EQ(field(lining.point_fields(), "thrust_N")[6], rows[2]);
  EXPECT_EQ(field(lining.point_fields(), "shear_N")[2], rows[3]);
  EXPECT_EQ(bolt.name(), "bolts");
  EXPECT_LT(field(bolt.cell_fields(), "thrust_N")[0], 0);
}

// Peaks of a lining's forces are those of its nodes' histories, with their signs, and tell what acted beside
// them at the same instant; the figures of a lining are the extremes over its nodes.
TEST(Supports, PeaksHaveSignsAndBelongToOneInstant) {
  std::string scene =
      "motions { where { y_max: 0 } velocity { x: 0 y: 0 } } body_loads { acceleration { x: 4 y: -10 } } "
      "linings { name: 'top' along { line { points { x: 0 y: 1 } points { x: 6 y: 1 } } } "
      "thickness: 0.5 young_modulus: 30e9 } ";
  constexpr int kNodes = 13;
  for (int node = 0; node < kNodes; ++node)
    for (const char* force : {"THRUST", "MOMENT"})
      scene += fmt::format("histories {{ name: '{}{}' quantity: {} at {{ x: {} y: 1 }} lining: 'top' }} ",
                           force, node, force, node / 2.0);
  Conversation run(scene);
  const double dt = 0.5 * run.model.critical_dt();
  struct Sample {
    double time, thrust, moment;
  };
  std::vector<std::vector<Sample>> nodes(kNodes);
  for (std::uint64_t n = 0; n <= 400; ++n) {
    run.advance(n, dt);
    for (int node = 0; node < kNodes; ++node)
      nodes[node].push_back({static_cast<double>(n) * dt, run.predicted.histories(2 * node),
                             run.predicted.histories(2 * node + 1)});
  }
  wire::Snapshot snapshot;
  run.participant.snapshot({}, snapshot);
  const auto& fields = snapshot.pieces(1).point_fields();
  const auto field = [&](const std::string& name) {
    const auto found = std::ranges::find(fields, name, &wire::Field::name);
    EXPECT_NE(found, fields.end()) << name;
    return found->values();
  };
  wire::Bye bye;
  run.participant.finish(bye);
  std::map<std::string, double> figures;
  for (const auto& figure : bye.figures()) figures[figure.name()] = figure.value();

  Sample thrust = nodes[0][0], pressed = thrust, bent = thrust;
  int at_thrust = 0, at_pressed = 0, at_bent = 0;
  for (int node = 0; node < kNodes; ++node) {
    const auto [least, most] = std::ranges::minmax_element(nodes[node], {}, &Sample::thrust);
    const auto [lowest, highest] = std::ranges::minmax_element(nodes[node], {}, &Sample::moment);
    EXPECT_EQ(field("peak_largest_thrust_N")[node], most->thrust);
    EXPECT_EQ(field("peak_least_thrust_N")[node], least->thrust);
    EXPECT_EQ(field("peak_largest_moment_Nm")[node], highest->moment);
    EXPECT_EQ(field("peak_least_moment_Nm")[node], lowest->moment);
    EXPECT_EQ(field("thrust_at_peak_largest_moment_N")[node], highest->thrust);
    EXPECT_EQ(field("thrust_at_peak_least_moment_N")[node], lowest->thrust);
    if (most->thrust > thrust.thrust) thrust = *most, at_thrust = node;
    if (least->thrust < pressed.thrust) pressed = *least, at_pressed = node;
    for (const Sample& sample : {*highest, *lowest})
      if (std::abs(sample.moment) > std::abs(bent.moment)) bent = sample, at_bent = node;
  }
  EXPECT_LT(pressed.thrust, 0);
  EXPECT_GT(std::abs(bent.moment), 0);
  EXPECT_EQ(figures["lining_top_largest_thrust_N"], thrust.thrust);
  EXPECT_EQ(figures["lining_top_largest_thrust_time_s"], thrust.time);
  EXPECT_EQ(figures["lining_top_largest_thrust_x_m"], at_thrust / 2.0);
  EXPECT_EQ(figures["lining_top_moment_at_largest_thrust_Nm"], thrust.moment);
  EXPECT_EQ(figures["lining_top_least_thrust_N"], pressed.thrust);
  EXPECT_EQ(figures["lining_top_least_thrust_x_m"], at_pressed / 2.0);
  EXPECT_EQ(figures["lining_top_moment_at_least_thrust_Nm"], pressed.moment);
  EXPECT_EQ(figures["lining_top_largest_moment_Nm"], bent.moment);
  EXPECT_EQ(figures["lining_top_largest_moment_time_s"], bent.time);
  EXPECT_EQ(figures["lining_top_largest_moment_x_m"], at_bent / 2.0);
  EXPECT_EQ(figures["lining_top_largest_moment_y_m"], 1);
  EXPECT_EQ(figures["lining_top_thrust_at_largest_moment_N"], bent.thrust);
}

using Case = adit::test::RefusedText;
class SupportsError : public testing::TestWithParam<Case> {};

TEST_P(SupportsError, NamesTheFieldAndTheRemedy) {
  const Case& refused = GetParam();
  adit::test::expect_refusal(
      [&] { with(refused.text, refused.name.starts_with("ring") ? ring_grid() : block_grid()); },
      refused.path, refused.message);
}

std::string lining(const std::string& along, const std::string& more = kConcreteWall) {
  return "linings { name: 'l' along { " + along + " } " + more + "} ";
}
const std::string kLine = "line { points { x: 1 y: 1 } points { x: 4 y: 1 } }";
const std::string kCircle = "circle { centre { x: 0 y: 0 } radius: 2 }";
const std::string kColumn =
    "linings { name: 'column' along { line { points { x: 2 y: 0 } points { x: 2 y: 1 } } } " + kConcreteWall;
const std::string kBolt = "bolts { from { x: 1 y: 1 } to { x: 1 y: 3 } ";

INSTANTIATE_TEST_SUITE_P(
    Scenes, SupportsError,
    testing::Values(
        Case{"no_young_modulus", lining(kLine, "thickness: 0.3 "), "continuum.linings[0].young_modulus",
             "is missing; give it, such as `30 GPa`, or a `section` of reinforced concrete"},
        Case{
            "thickness_beside_section",
            lining(kLine,
                   "thickness: 0.3 section { thickness: 0.3 cover: 0.04 concrete { class: 'C30/37' } steel { "
                   "class: 'B500B' } outer { diameter: 0.02 spacing: 0.2 } } "),
            "continuum.linings[0].thickness", "is given beside `section`, which states it"},
        Case{"circle_on_a_block", lining("circle { centre { x: 3 y: 1.5 } radius: 1.2 }"),
             "continuum.linings[0].along.circle", "has no sides of zones along it at (4.2, 1.5) m"},
        Case{"line_leaves_the_points",
             lining("line { points { x: 1 y: 1 } points { x: 3 y: 1 } points { x: 5 y: 2 } }"),
             "continuum.linings[0].along.line", "has no sides of zones along it at (3, 1) m"},
        Case{"line_leaves_the_grid", lining("line { points { x: 1 y: 1 } points { x: 8 y: 1 } }"),
             "continuum.linings[0].along.line", "has no sides of zones along it at (6, 1) m"},
        Case{"line_runs_back",
             lining("line { points { x: 1 y: 1 } points { x: 4 y: 1 } points { x: 2 y: 1 } }"),
             "continuum.linings[0].along.line.points", "passes every place once"},
        Case{"line_crosses_itself",
             lining(
                 "line { points { x: 1 y: 1 } points { x: 4 y: 1 } points { x: 4 y: 2 } points { x: 2 y: 2 } "
                 "points { x: 2 y: 0 } }"),
             "continuum.linings[0].along.line.points", "passes every place once"},
        Case{"hinge_that_yields",
             lining(kLine, kConcreteWall + "joints { at { x: 2 y: 1 } yield_moment: 1e3 } "),
             "continuum.linings[0].joints[0].yield_moment", "give its rotational_stiffness too"},
        Case{"one_point", lining("line { points { x: 1 y: 1 } }"), "continuum.linings[0].along.line.points",
             "has 1 elements, expected at least 2"},
        Case{"point_twice", lining("line { points { x: 1 y: 1 } points { x: 1 y: 1 } }"),
             "continuum.linings[0].along.line.points", "twice in succession"},
        Case{"no_path", lining(""), "continuum.linings[0].along", "give `circle`, `line` or `wall`"},
        Case{"half_an_arc", lining("circle { centre { x: 0 y: 0 } radius: 2 from: 1 }"),
             "continuum.linings[0].along.circle", "give `from` and `to`"},
        Case{"arc_backwards", lining("circle { centre { x: 0 y: 0 } radius: 2 from: 1 to: 0 }"),
             "continuum.linings[0].along.circle.to", "must be larger than `from`"},
        Case{"ring_wall_in_pieces", lining("wall { x_min: -9 }"), "continuum.linings[0].along.wall",
             "several separate lines of edges"},
        Case{"ring_wall_nowhere", lining("wall { x_min: 9 }"), "continuum.linings[0].along.wall",
             "holds no whole edge"},
        Case{"no_section", lining(kLine, "young_modulus: 1e9 "), "continuum.linings[0]",
             "give either `thickness`, or both `area` and `inertia`"},
        Case{"area_alone", lining(kLine, "young_modulus: 1e9 area: 0.3 "), "continuum.linings[0]",
             "both `area` and `inertia`"},
        Case{"two_sections", lining(kLine, kConcreteWall + "area: 0.3 inertia: 1e-3 "),
             "continuum.linings[0]", "give either `thickness`"},
        Case{"soft_as_air", lining(kLine, "thickness: 0.3 young_modulus: 0 "),
             "continuum.linings[0].young_modulus", "is 0 Pa, expected a pressure above 0 Pa"},
        Case{"thin_as_air", lining(kLine, "thickness: -1 young_modulus: 1e9 "),
             "continuum.linings[0].thickness", "is -1 m, expected a length above 0 m"},
        Case{"poisson", lining(kLine, kConcreteWall + "poisson_ratio: 0.5 "),
             "continuum.linings[0].poisson_ratio", "expected a pure number above -1 and below 0.5"},
        Case{"joint_off_the_lining", lining(kLine, kConcreteWall + "joints { at { x: 2 y: 2 } } "),
             "continuum.linings[0].joints[0]", "1 m from the lining's nearest node; put it on the lining"},
        Case{"joint_nowhere", lining(kLine, kConcreteWall + "joints {} "), "continuum.linings[0].joints[0]",
             "give either `at` or `angle`"},
        Case{"joint_at_an_end", lining(kLine, kConcreteWall + "joints { at { x: 4 y: 1 } } "),
             "continuum.linings[0].joints[0]",
             "at an end of the lining, where no other lining is; leave it out"},
        Case{
            "segments_at_an_end",
            lining(kLine, kConcreteWall + "joints { at { x: 4 y: 1 } contact { height: 0.1 } } "),
            "continuum.linings[0].joints[0]",
            "is of segments (`contact`), but lies at an end of the lining, where none follows; leave it out"},
        Case{"segments_where_others_meet",
             lining(kLine, kConcreteWall +
                               "first_end_fixed: true joints { at { x: 1 y: 1 } contact { height: 0.1 } } ") +
                 "linings { name: 'm' along { line { points { x: 1 y: 1 } points { x: 1 y: 3 } } } " +
                 kConcreteWall + "}",
             "continuum.linings[0].joints[0]", "where others meet it; put it inside the lining"},
        Case{
            "segments_of_one_beam",
            lining(kLine, kConcreteWall +
                              "joints { at { x: 2 y: 1 } contact { height: 0.1 } } joints { at { x: 3 y: 1 } "
                              "contact { height: 0.1 } } "),
            "continuum.linings[0].joints[1]",
            "is one beam from joints[0], but segments are at least two beams long; use shorter zones"},
        Case{"ring_segments_of_one_beam",
             lining(kCircle,
                    kConcreteWall +
                        "joints { angle: 0 contact { height: 0.1 } } joints { angle: -0.785 contact { "
                        "height: 0.1 } } "),
             "continuum.linings[0].joints[1]", "is one beam from joints[0]"},
        Case{"joint_where_another_is_joined",
             lining(kLine, kConcreteWall + "joints { at { x: 2 y: 1 } } ") + kColumn + "}",
             "continuum.linings[0].joints[0]",
             "lies between two beams of the lining at (2, 1) m, where `column` may be joined to either; let "
             "two "
             "linings end here instead, one of them with the joint, or hinge `column` by a joint at its end"},
        Case{"joint_where_another_is_sprung",
             kColumn + "joints { at { x: 2 y: 1 } rotational_stiffness: 1e6 } } " +
                 lining(kLine, kConcreteWall + "joints { at { x: 2 y: 1 } } "),
             "continuum.linings[1].joints[0]", "`column` may be joined to either"},
        Case{"angle_on_a_line", lining(kLine, kConcreteWall + "joints { angle: 1 } "),
             "continuum.linings[0].joints[0].angle", "follows none; give `at` instead"},
        Case{"ring_joint_twice",
             lining(kCircle, kConcreteWall + "joints { angle: 0 } joints { angle: 0.1 } "),
             "continuum.linings[0].joints[1]", "at the same node as joints[0]"},
        Case{"joint_of_negative_stiffness",
             lining(kLine, kConcreteWall + "joints { at { x: 2 y: 1 } rotational_stiffness: -1 } "),
             "continuum.linings[0].joints[0].rotational_stiffness",
             "is -1 N*m/rad, expected a quantity in N*m/rad of at least 0"},
        Case{"joint_without_strength",
             lining(kLine, kConcreteWall + "joints { at { x: 2 y: 1 } yield_moment: 0 } "),
             "continuum.linings[0].joints[0].yield_moment", "is 0 N*m, expected"},
        Case{"stage_without_statics", lining(kLine, kConcreteWall + "stage: 1 "),
             "continuum.linings[0].stage", "the scene has no statics"},
        Case{"bolt_stage_without_statics", kBolt + "area: 1e-3 stage: 2 }", "continuum.bolts[0].stage",
             "the scene has no statics"},
        Case{"same_name", lining(kLine) + lining("line { points { x: 1 y: 2 } points { x: 4 y: 2 } }"),
             "continuum.linings[1].name", "`l` is taken by another lining"},
        Case{"two_on_one_edge",
             lining(kLine) +
                 "linings { name: 'm' along { line { points { x: 3 y: 1 } points { x: 5 y: 1 } } } " +
                 kConcreteWall + "}",
             "continuum.linings[1]", "from (3, 1) m to (4, 1) m, where continuum.linings[0] is already"},
        Case{"bolt_off_the_edges", "bolts { from { x: 1 y: 1 } to { x: 3 y: 2 } area: 1e-3 }",
             "continuum.bolts[0]", "has no sides of zones along it at (1, 1) m"},
        Case{"bolt_without_length", "bolts { from { x: 1 y: 1 } to { x: 1 y: 1 } area: 1e-3 }",
             "continuum.bolts[0].to", "give the bolt a length"},
        Case{"bolt_without_area", kBolt + "area: 0 }", "continuum.bolts[0].area",
             "is 0 m^2, expected an area above 0 m^2"},
        Case{"bolt_without_strength", kBolt + "area: 1e-3 yield_force: 0 }", "continuum.bolts[0].yield_force",
             "is 0 N, expected a force above 0 N"},
        Case{"bolts_without_spacing", kBolt + "area: 1e-3 spacing: -2 }", "continuum.bolts[0].spacing",
             "is -2 m, expected a length above 0 m"}),
    adit::test::kRefusalName);

}  // namespace
}  // namespace adit::fdm::test::supports_test

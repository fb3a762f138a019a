// Tunnels with linings of beams and zones become blocks that follow their opening, linings, and what belongs
// to them.
#include "coupler/tunnel/grid_tunnels.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "coupler/tunnel/expand.hpp"
#include "fdm_server/model/grid/read_grid.hpp"
#include "protocol/scene/fields/check_rules.hpp"
#include "tests/support/local_participants.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/coupler/tunnel/tunnels.hpp"

namespace adit::coupler::grid_tunnels_test {
namespace {

using std::numbers::pi;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kConcrete =
    "thickness: 0.4 material { young_modulus: 3e10 poisson_ratio: 0.2 density: 2500 } ";
const std::string kCircle = "circle { radius: 3 } ", kHorseshoe = "horseshoe { width: 6 height: 5 } ",
                  kBox = "box { width: 8 height: 4 } ";

std::string tunnel(const std::string& shape, const std::string& lining, const std::string& more = "",
                   const std::string& centre = "x: 1 y: -12") {
  return "centre { " + centre + " } " + shape + "lining { " + lining + " } " + more;
}

scene::Scene scene_with(const std::vector<std::string>& tunnels) {
  scene::Scene scene = test::scene_with(tunnels);
  scene.mutable_statics();
  return scene;
}

scene::Scene expanded(const std::vector<std::string>& tunnels) {
  const Expansion expansion = expand_tunnels(scene_with(tunnels));
  protocol::check_rules(expansion.scene);
  return expansion.scene;
}

double area_of(const fdm::Grid& grid) {
  double sum = 0;
  for (std::size_t zone = 0; zone < grid.zones.size(); ++zone) sum += fdm::area(fdm::corners(grid, zone));
  return sum;
}

// Requirement: zones fill the block but for an opening that was always there, without gaps or overlaps, for
// every shape, wherever the tunnel lies between the lines of the block; and linings find their path.
TEST(GridTunnels, TheGridFollowsEachShape) {
  const double block = 40 * 32, outline = 2 * (80 + 64);
  const double half_circle = pi * 3 * 3 / 2;
  for (const auto& [shape, inside, around] :
       {std::tuple(kCircle, 2 * half_circle, 2 * pi * 3),
        std::tuple(kHorseshoe, half_circle + 12, 3 * pi + 10), std::tuple(kBox, 32.0, 24.0)})
    for (const char* centre : {"x: 1 y: -12", "x: 1.2 y: -12.1", "x: 0.75 y: -11.75"})
      for (const char* as : {"as: BEAM ", "as: ZONES "})
        for (const std::string stage : {"", "stage: 1"}) {
          const bool beams = as[4] == 'B';
          SCOPED_TRACE(shape + centre + as + stage);
          const scene::Scene scene = expanded({tunnel(shape, as + kConcrete, stage, centre)});
          const fdm::Grid grid = fdm::read_grid(scene.continuum());
          // A beam's axis lies 0.2 m outside; the corners of an outline stay corners.
          const double offset = beams ? 0.2 : 0.0;
          const double corners = shape == kCircle ? pi : shape == kHorseshoe ? pi / 2 + 2 : 4;
          const double opening = inside + around * offset + corners * offset * offset;
          EXPECT_NEAR(area_of(grid), block - (stage.empty() ? opening : 0), 0.005 * opening + 1e-9);
          const auto hole = static_cast<double>(grid.boundary.size()) - outline;
          if (stage.empty())
            EXPECT_GE(hole, 40);
          else
            EXPECT_EQ(hole, 0);
          test::local_model(scene);
        }
}

// Requirement: a box has no zone that is not its own: the area of the zones is that of the block without it.
TEST(GridTunnels, ABoxIsExact) {
  const scene::Scene scene = expanded({tunnel(kBox, "as: BEAM " + kConcrete)});
  EXPECT_NEAR(area_of(fdm::read_grid(scene.continuum())), 40 * 32 - 8.4 * 4.4, 1e-9);
}

// Requirement: zones around a circle are equally long, so that beams are.
TEST(GridTunnels, BeamsOfACircleAreEqual) {
  const scene::Scene scene = expanded({tunnel(kCircle, "as: BEAM " + kConcrete, "", "x: 1.2 y: -12.1")});
  const fdm::Grid grid = fdm::read_grid(scene.continuum());
  double least = 1e9, largest = 0;
  for (const fdm::Edge& edge : grid.boundary) {
    const double x = grid.x[edge.from] - 1.2, y = grid.y[edge.from] + 12.1;
    if (std::abs(std::hypot(x, y) - 3.2) > 1e-9) continue;
    const double length =
        std::hypot(grid.x[edge.to] - grid.x[edge.from], grid.y[edge.to] - grid.y[edge.from]);
    least = std::min(least, length);
    largest = std::max(largest, length);
  }
  EXPECT_NEAR(least, largest, 1e-9);
  EXPECT_GT(least, 0.1);
}

// Requirement: several tunnels share a block; blocks that hold none keep their numbers, their names and their
// zones.
TEST(GridTunnels, SeveralTunnelsInOneOfTheBlocks) {
  scene::Scene scene = scene_with({tunnel(kCircle, "as: BEAM " + kConcrete, "name: 'left'", "x: -9 y: -12"),
                                   tunnel(kBox, "as: BEAM " + kConcrete, "name: 'right'", "x: 10 y: -12")});
  auto& continuum = *scene.mutable_continuum();
  continuum.clear_block();
  ASSERT_TRUE(google::protobuf::TextFormat::MergeFromString(
      "blocks { name: 'rock' rectangle { x_min: -19 x_max: 21 y_min: -32 y_max: -4 } along { zones: 80 } "
      "across { zones: 56 } }"
      "blocks { name: 'top' rectangle { x_min: -19 x_max: 21 y_min: -4 y_max: 0 } along { zones: 80 } across "
      "{ zones: 4 ratio: 1.2 } }",
      &continuum));
  const Expansion expansion = expand_tunnels(scene);
  const auto& blocks = expansion.scene.continuum().blocks();
  EXPECT_EQ(blocks[1].name(), "top");
  EXPECT_EQ(blocks[1].across().ratio(), 1.2);
  EXPECT_EQ(blocks[0].name(), "rock");
  for (const auto& block : blocks) EXPECT_THAT(block.name(), ::testing::AnyOf("rock", "top"));
  const fdm::Grid grid = fdm::read_grid(expansion.scene.continuum());
  EXPECT_NEAR(area_of(grid), 40 * 32 - pi * 3.2 * 3.2 - 8.4 * 4.4, 0.2);
  EXPECT_EQ(expansion.scene.continuum().linings_size(), 2);
  EXPECT_FALSE(expansion.scene.has_particles());
  EXPECT_EQ(expansion.at_tunnel({"continuum.linings[1].young_modulus", "is 0"}).path(), "tunnels[1]");
  EXPECT_EQ(
      expansion.at_tunnel({"continuum.blocks[" + std::to_string(blocks.size() - 1) + "]", "is flat"}).path(),
      "tunnels[1]");
  EXPECT_EQ(expansion.at_tunnel({"continuum.blocks[1].along", "is 0"}).path(), "continuum.blocks[1].along");
}

// Requirement: a tunnel of beams may stand beside one of particles.
TEST(GridTunnels, BesideATunnelOfParticles) {
  const scene::Scene scene = expanded({test::replaced(test::circular(), "x: 1", "x: -9"),
                                       tunnel(kCircle, "as: BEAM " + kConcrete, "", "x: 11 y: -12")});
  EXPECT_TRUE(scene.has_particles());
  EXPECT_EQ(scene.continuum().linings_size(), 1);
}

// Requirement: the tunnel is excavated in its stage, and its layers come one after another, from the ground
// inwards: the first one's axis lies half its thickness outside what all take up.
TEST(GridTunnels, LayersFollowTheExcavation) {
  const scene::Scene scene = expanded(
      {tunnel(kCircle,
              "as: BEAM layers { name: 'shotcrete' " + kConcrete +
                  " interface { friction_angle: 0.5 } } layers { name: 'concrete' section { thickness: 0.3 "
                  "cover: 0.04 concrete { class: 'C30/37' } steel { class: 'B500B' } inner { diameter: 0.016 "
                  "spacing: 0.15 } outer { "
                  "diameter: 0.016 spacing: 0.15 } } interface { friction_angle: 0.2 } }",
              "name: 'tube' stage: 2 released: 0.4 sections: 0")});
  const auto& continuum = scene.continuum();
  ASSERT_EQ(continuum.excavations_size(), 1);
  EXPECT_EQ(continuum.excavations(0).where().group(), "tube_opening");
  EXPECT_EQ(continuum.excavations(0).stage(), 2u);
  EXPECT_EQ(continuum.excavations(0).released(), 0.4);
  ASSERT_EQ(continuum.linings_size(), 2);
  const auto &first = continuum.linings(0), &second = continuum.linings(1);
  EXPECT_EQ(first.name(), "tube_shotcrete");
  EXPECT_NEAR(first.along().circle().radius(), 3 + 0.3 + 0.2, 1e-12);
  EXPECT_EQ(first.thickness(), 0.4);
  EXPECT_EQ(first.stage(), 3u);
  EXPECT_EQ(first.interface().friction_angle(), 0.5);
  EXPECT_EQ(second.name(), "tube_concrete");
  EXPECT_EQ(second.on(), "tube_shotcrete");
  EXPECT_FALSE(second.has_along());
  EXPECT_EQ(second.section().concrete().class_(), "C30/37");
  EXPECT_FALSE(second.has_young_modulus());
  EXPECT_EQ(second.stage(), 4u);
  EXPECT_EQ(second.interface().friction_angle(), 0.2);
  test::local_model(scene);
}

// Requirement: segments meet in joints whose faces touch over the whole thickness, unless stated, with the
// bolts and the gasket that a lining of particles would have.
TEST(GridTunnels, SegmentsOfBeams) {
  const scene::Scene scene = expanded({tunnel(kCircle,
                                              "as: BEAM segments: 4 first_joint: 0.3 bolts { length: 0.4 "
                                              "stiffness: 1e8 pretension: 1e3 strength: 1e5 } "
                                              "gasket { opening: [-0.01, 0, 0.01] force: [-5e4, -1e3, 0] } " +
                                                  kConcrete)});
  ASSERT_EQ(scene.continuum().linings(0).joints_size(), 4);
  const auto& joint = scene.continuum().linings(0).joints(1);
  EXPECT_NEAR(joint.angle(), 0.3 + pi / 2, 1e-12);
  EXPECT_EQ(joint.contact().height(), 0.4);
  EXPECT_EQ(joint.bolts(0).stiffness(), 1e8);
  EXPECT_EQ(joint.bolts(0).pretension(), 1e3);
  EXPECT_EQ(joint.bolts(0).yield_force(), 1e5);
  EXPECT_EQ(joint.gasket().force().force(0), -5e4);
  test::local_model(scene);
  EXPECT_EQ(expanded({tunnel(kCircle, "as: BEAM segments: 4 contact { height: 0.2 } " + kConcrete)})
                .continuum()
                .linings(0)
                .joints(0)
                .contact()
                .height(),
            0.2);
}

// Requirement: layers of zones are rings with their own material, no longer than they are thick, and may slip
// on what lies outside.
TEST(GridTunnels, LayersOfZones) {
  const scene::Scene scene =
      expanded({tunnel(kCircle,
                       "as: ZONES layers { name: 'outer' " + kConcrete +
                           " interface { friction_angle: 0.5 } } layers { name: 'inner' section { "
                           "thickness: 0.8 concrete { class: 'C30/37' } } }",
                       "sections: 8")});
  const auto& continuum = scene.continuum();
  ASSERT_EQ(continuum.materials_size(), 2);
  EXPECT_EQ(continuum.materials(0).where().group(), "tunnel_outer");
  EXPECT_EQ(continuum.materials(0).material().young_modulus(), 3e10);
  EXPECT_NEAR(continuum.materials(1).material().young_modulus(), 32.84e9,
              0.01e9);  // EN 1992-1-1, table 3.1: 33 GPa
  ASSERT_EQ(continuum.interfaces_size(), 1);
  EXPECT_NEAR(continuum.interfaces(0).along().circle().radius(), 4.2, 1e-12);
  EXPECT_EQ(continuum.sections_size(), 16);
  const fdm::Grid grid = fdm::read_grid(continuum);
  double area = 0;
  for (const fdm::Group& group : grid.groups)
    for (const auto zone : group.zones) area += fdm::area(fdm::corners(grid, zone));
  EXPECT_NEAR(area, pi * (4.2 * 4.2 - 9), 0.01 * area);
  for (const auto& block : continuum.blocks()) {
    if (block.name() != "tunnel_inner") continue;
    EXPECT_GT(block.across().zones(), 1u);
  }
  test::local_model(scene);
}

// Requirement: a tunnel that is excavated takes the ground in the places of its layers with its opening; each
// layer comes into being in its stage, in the places of which all are filled before.
TEST(GridTunnels, LayersOfZonesInStages) {
  const std::string layers = "as: ZONES layers { name: 'outer' " + kConcrete +
                             " } layers { name: 'inner' stage: 5 " + kConcrete + " }";
  const scene::Scene scene = expanded({tunnel(kCircle, layers, "stage: 2 released: 0.4")});
  const auto& continuum = scene.continuum();
  ASSERT_EQ(continuum.excavations_size(), 3);
  std::vector<std::string> groups;
  for (const auto& excavation : continuum.excavations()) {
    EXPECT_EQ(excavation.stage(), 2u);
    EXPECT_EQ(excavation.released(), 0.4);
    groups.push_back(excavation.where().group());
  }
  EXPECT_THAT(groups, ElementsAre("tunnel_opening", "tunnel_outer", "tunnel_inner"));
  ASSERT_EQ(continuum.materials_size(), 2);
  EXPECT_EQ(continuum.materials(0).stage(), 3u);
  EXPECT_EQ(continuum.materials(1).stage(), 5u);
  EXPECT_NEAR(area_of(fdm::read_grid(continuum)), 40 * 32, 1e-9);
  test::local_model(scene);
}

// Requirement: a layer that is cast in a tunnel that was always there leaves its place free until then.
TEST(GridTunnels, ALayerOfZonesInATunnelThatWasAlwaysThere) {
  const scene::Scene scene =
      expanded({tunnel(kCircle, "as: ZONES layers { name: 'outer' " + kConcrete +
                                    " } layers { name: 'inner' stage: 1 " + kConcrete + " }")});
  const auto& continuum = scene.continuum();
  ASSERT_EQ(continuum.excavations_size(), 1);
  EXPECT_EQ(continuum.excavations(0).where().group(), "tunnel_inner");
  EXPECT_EQ(continuum.excavations(0).stage(), 0u);
  EXPECT_EQ(continuum.materials(1).stage(), 1u);
  test::local_model(scene);
}

// Requirement: forces are recorded where those of particles are, with the same names.
TEST(GridTunnels, HistoriesOfForcesAndConvergence) {
  const auto histories = expanded({tunnel(kCircle, "as: BEAM " + kConcrete, "name: 'tube' sections: 4")})
                             .continuum()
                             .histories();
  ASSERT_EQ(histories.size(), 4 * 3 + 8);
  EXPECT_EQ(histories[3].name(), "tube_section_2");
  EXPECT_EQ(histories[3].quantity(), scene::THRUST);
  EXPECT_EQ(histories[3].lining(), "tube");
  EXPECT_NEAR(histories[3].at().x(), 1, 1e-9);
  EXPECT_NEAR(histories[3].at().y(), -12 + 3.2, 1e-9);
  EXPECT_EQ(histories[12].name(), "tube_crown");
}

void expect_refused(const std::string& tunnel, const std::string& path, const std::string& text) {
  test::expect_refusal([&] { expand_tunnels(scene_with({tunnel})); }, path, text);
}

TEST(GridTunnels, WhatOtherModelsOfLiningsHaveIsRefused) {
  const std::string beam = "as: BEAM " + kConcrete, zones = "as: ZONES " + kConcrete,
                    particles = "particles { radius: 0.05 ground: 2 overlap: 1 } ";
  expect_refused(tunnel(kCircle, beam, particles), "tunnels[0].particles",
                 "is given, but the lining is of beams; leave it out, or give `lining.as: particles`");
  expect_refused(tunnel(kCircle, beam + "bonds { }"), "tunnels[0].lining.bonds",
                 "is given, but the lining is of beams");
  expect_refused(tunnel(kCircle, beam + "segments: 2 keys { stiffness: 1 }"), "tunnels[0].lining.keys",
                 "or give `as: particles`");
  expect_refused(tunnel(kCircle, zones + "friction: 0.5"), "tunnels[0].lining.friction",
                 "the lining is of zones; leave it out, or give an `interface`");
  expect_refused(tunnel(kCircle, beam + "to_ground { }"), "tunnels[0].lining.to_ground",
                 "without `interface` it is tied");
  expect_refused(tunnel(kCircle, zones + "segments: 4"), "tunnels[0].lining",
                 "has joints of segments, which zones do not have");
  expect_refused(tunnel(kCircle, zones + "interface { friction_angle: 0.5 } ", "stage: 1"),
                 "tunnels[0].lining.interface",
                 "is given, but zones that come into being in stage 2 are tied to what lies outside them");
  expect_refused(tunnel(kCircle, "as: ZONES layers { name: 'a' stage: 3 " + kConcrete + " }", "stage: 4"),
                 "tunnels[0].lining.layers[0].stage",
                 "is 3, but what lies outside the layer comes in stage 4; give at least that");
  expect_refused(tunnel(kBox, beam + "segments: 4"), "tunnels[0].lining.segments",
                 "only the lining of a circle has segments");
  expect_refused(tunnel(kCircle,
                        "as: BEAM thickness: 0.4 material { young_modulus: 3e10 poisson_ratio: 0.2 density: "
                        "2500 mohr_coulomb { cohesion: 1e5 } }"),
                 "tunnels[0].lining.material",
                 "has a law beyond elasticity, but the lining is of beams; give a `section`");
  expect_refused(tunnel(kCircle, kConcrete), "tunnels[0]",
                 "has a lining of particles, but no `particles`; state them, or give `lining.as: beam`");
  expect_refused(tunnel(kCircle, kConcrete + "interface { }", particles), "tunnels[0].lining.interface",
                 "is given, but the lining is of particles; leave it out, or give `friction`");
  expect_refused(tunnel(kCircle, kConcrete + "layers { name: 'a' }", particles), "tunnels[0].lining.layers",
                 "or give `as: beam`");
  expect_refused(tunnel(kCircle, "section { thickness: 0.3 concrete { class: 'C30/37' } }", particles),
                 "tunnels[0].lining.section",
                 "which a lattice of discs does not follow; give `particles.size`");
  expect_refused(tunnel(kCircle, kConcrete, particles + "zones { around: 1 }"), "tunnels[0].zones",
                 "the lining is of particles");
}

TEST(GridTunnels, LiningsStatedTwiceOrNotAtAllAreRefused) {
  expect_refused(tunnel(kCircle, "as: BEAM thickness: 0.3"), "tunnels[0].lining",
                 "has no material; give `thickness` and `material`, or a `section`");
  expect_refused(tunnel(kCircle, "as: BEAM"), "tunnels[0].lining", "has no thickness");
  expect_refused(
      tunnel(kCircle, "as: BEAM thickness: 0.3 section { thickness: 0.3 concrete { class: 'C30/37' } }"),
      "tunnels[0].lining.thickness", "is given beside `section`, which states it; leave one out");
  expect_refused(tunnel(kCircle, "as: BEAM layers { name: 'a' " + kConcrete + "} " + kConcrete),
                 "tunnels[0].lining.thickness", "is given beside `layers`, each of which states its own");
  expect_refused(tunnel(kCircle, "as: BEAM layers { name: 'a' thickness: 0.2 }"),
                 "tunnels[0].lining.layers[0]", "has no material");
  expect_refused(tunnel(kCircle, "as: BEAM segments: 3 layers { name: 'a' " + kConcrete +
                                     "} layers { name: 'b' " + kConcrete + "}"),
                 "tunnels[0].lining.layers", "are given beside joints of segments");
  expect_refused(tunnel(kCircle, "as: ZONES section { thickness: 0.3 concrete { class: 'C31' } }"),
                 "tunnels[0].lining.section.concrete.class", "is `C31`, expected a class of EN 1992-1-1");
  expect_refused(tunnel(kCircle, "as: ZONES section { thickness: 0.3 concrete { } }"),
                 "tunnels[0].lining.section.concrete", "needs its strength once");
  expect_refused(tunnel(kCircle, "as: BEAM contact { height: 0.1 } " + kConcrete),
                 "tunnels[0].lining.contact", "has no joints");
}

// Requirement: what cells do not have of a section is refused.
TEST(GridTunnels, SectionsOfCells) {
  const std::string cells = "particles { size: 0.1 ground: 2 overlap: 1 }",
                    bars = "cover: 0.04 steel { class: 'B500B' } inner { diameter: 0.012 spacing: 0.1 } ";
  const auto expect = [&](const std::string& section, const std::string& path, const std::string& message) {
    expect_refused(tunnel(kCircle, "section { thickness: 0.3 " + section, cells), "tunnels[0].lining" + path,
                   message);
  };
  expect(bars + "concrete { class: 'C30/37' tension_stiffening: false } }",
         ".section.concrete.tension_stiffening", "where it follows from the bond of the bars");
  expect(bars + "concrete { class: 'C30/37' fibres { residual_strength_1: 3e6 residual_strength_3: 2e6 } } }",
         ".section.concrete.fibres", "which break as plain concrete");
  expect(bars + "concrete { class: 'C30/37' } } bonds { strength_of_material: true }", ".bonds",
         "is given beside `section`");
  expect("steel { class: 'B500B' } inner { diameter: 0.012 spacing: 0.1 } concrete { class: 'C30/37' } }",
         ".section.inner", "has bars, but the section has no `cover`");
}

// Requirement: a tunnel needs equal zones around it, and room for those that follow it.
TEST(GridTunnels, WhereNoGridCanBeFittedIsRefused) {
  const std::string beam = "as: BEAM " + kConcrete;
  expect_refused(tunnel(kCircle, beam, "", "x: 1 y: -2"), "tunnels[0]",
                 "which no rectangle of equal zones holds; give the continuum a `block` there");
  expect_refused(tunnel(kCircle, beam, "", "x: 1 y: -3.3"), "tunnels[0]",
                 "of a zone's width between its lining and the edge of the zones around it");
  expect_refused(tunnel("circle { radius: 0.2 } ", beam, "zones { around: 0.05 }", "x: 1 y: -12"),
                 "tunnels[0]", "zones of its block in and around it");
  test::expect_refusal(
      [&] {
        expand_tunnels(scene_with({tunnel(kCircle, beam), tunnel(kCircle, beam, "", "x: 8 y: -12")}));
      },
      "tunnels[1]",
      "has an area of fitted zones that overlaps the one of tunnels[0]; move the tunnels apart");
}

}  // namespace
}  // namespace adit::coupler::grid_tunnels_test

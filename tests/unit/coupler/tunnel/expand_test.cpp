// Tunnels become particles, joints, springs, sections, histories and overlaps.
#include "coupler/tunnel/expand.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "dem_server/model/reading/read_model.hpp"
#include "protocol/geometry/selection.hpp"
#include "protocol/scene/fields/check_rules.hpp"
#include "tests/support/local_participants.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/coupler/tunnel/tunnels.hpp"

namespace adit::coupler::expand_test {
namespace {

using std::numbers::pi;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

scene::Particles particles_of(const std::string& tunnel) {
  const Expansion expansion = expand_tunnels(test::scene_with({tunnel}));
  protocol::check_rules(expansion.scene);
  return expansion.scene.particles();
}

void expect_point(const scene::Point& point, double x, double y) {
  EXPECT_NEAR(point.x(), x, 1e-12);
  EXPECT_NEAR(point.y(), y, 1e-12);
}

TEST(ExpandTunnels, ASceneWithoutTunnelsStaysAsItIs) {
  const scene::Scene scene = test::scene_with({});
  const Expansion expansion = expand_tunnels(scene);
  EXPECT_EQ(expansion.scene.SerializeAsString(), scene.SerializeAsString());
  EXPECT_THAT(expansion.notes, IsEmpty());
}

// Requirement: what the zones around compute and the tunnel's particles do not is told.
TEST(ExpandTunnels, ParticlesAloneGetNoContinuum) {
  scene::Scene scene;
  scene.mutable_particles();
  EXPECT_EQ(expand_tunnels(scene).scene.SerializeAsString(), scene.SerializeAsString());
}

TEST(ExpandTunnels, TellsWhereItsGroundIsElasticBesideZonesThatYield) {
  scene::Scene scene = test::scene_with({test::circular("")});
  const auto told = Contains(HasSubstr("elastic where continuum.material has a law"));
  EXPECT_THAT(expand_tunnels(scene).notes, Not(told));
  *scene.mutable_continuum()->mutable_material() = scene.material();
  scene.mutable_continuum()->mutable_material()->mutable_mohr_coulomb()->set_cohesion(1e5);
  EXPECT_THAT(expand_tunnels(scene).notes, told);
  auto& particles = *scene.mutable_tunnels(0)->mutable_particles();
  particles.mutable_bonds()->set_strength_of_material(true);
  EXPECT_THAT(expand_tunnels(scene).notes, Not(told));
  particles.clear_bonds();
  *particles.mutable_material() = scene.material();
  EXPECT_THAT(expand_tunnels(scene).notes, Not(told));
}

// Requirement: cells in the place of zones break as the zones' material states; discs, which cannot, stay
// elastic.
TEST(ExpandTunnels, CellsBreakAsTheZonesThatTheyReplaceState) {
  for (const bool cells : {true, false}) {
    scene::Scene scene = test::scene_with({test::circular("")});
    auto& particles = *scene.mutable_tunnels(0)->mutable_particles();
    if (cells) {
      particles.clear_radius();
      particles.set_size(0.1);
    }
    *scene.mutable_continuum()->mutable_material() = scene.material();
    scene.mutable_continuum()->mutable_material()->mutable_fracture()->set_tensile_strength(1e6);
    EXPECT_EQ(expand_tunnels(scene).scene.particles().material().has_fracture(), cells);
  }
}

// Requirement: the lining is a group that only touches the ground, under the gravity of the continuum.
TEST(ExpandTunnels, ALiningInGround) {
  const auto particles = particles_of(test::circular("friction: 0.3"));
  EXPECT_EQ(particles.within().annulus().inner_radius(), 3);
  EXPECT_EQ(particles.within().annulus().outer_radius(), 5.5);
  ASSERT_EQ(particles.groups_size(), 1);
  EXPECT_EQ(particles.groups(0).name(), "tunnel");
  EXPECT_EQ(particles.groups(0).where().annulus().outer_radius(), 3.5);
  EXPECT_EQ(particles.groups(0).contacts().friction(), 0.3);
  EXPECT_FALSE(particles.groups(0).has_stage());
  ASSERT_EQ(particles.between_size(), 1);
  EXPECT_EQ(particles.between(0).first(), "tunnel");
  EXPECT_EQ(particles.between(0).second(), "particles");
  EXPECT_FALSE(particles.between(0).has_bonds());
  EXPECT_TRUE(particles.has_bonds());  // with `contacts` alone the ground would be loose
  ASSERT_EQ(particles.body_loads_size(), 1);
  EXPECT_EQ(particles.body_loads(0).acceleration().y(), -9.81);
  EXPECT_EQ(particles.joints_size() + particles.springs_size() + particles.excavations_size(), 0);
}

// Requirement: `size` makes the region of cells that end at the faces of the lining and of the region;
// nothing of what a lattice needs is set.
TEST(ExpandTunnels, ALiningOfCells) {
  const auto particles = particles_of(test::replaced(test::circular(), "radius: 0.05", "size: 0.12 seed: 3"));
  EXPECT_FALSE(particles.has_packing());
  EXPECT_EQ(particles.cells().size(), 0.12);
  EXPECT_EQ(particles.cells().seed(), 3u);
  EXPECT_LT(particles.cells().x_min(), 1 - 5.5 - 0.12);
  EXPECT_GT(particles.cells().y_max(), -12 + 5.5 + 0.12);
  EXPECT_FALSE(particles.groups(0).has_bends_as_solid());
  EXPECT_FALSE(particles.remove_floaters());
  EXPECT_NE(particles.histories(particles.histories_size() - 1).quantity(), scene::CRACK_WIDTH);
  const auto breakable = particles_of(test::replaced(
      test::circular("bonds { fracture { tensile_strength: 3e6 fracture_energy: 100 cohesion: 1e7 } }"),
      "radius: 0.05", "size: 0.12"));
  const scene::History& last = breakable.histories(breakable.histories_size() - 1);
  EXPECT_EQ(last.quantity(), scene::CRACK_WIDTH);
  EXPECT_EQ(last.group(), "tunnel");
  scene::Scene scene = test::scene_with({test::replaced(test::circular(), "radius: 0.05", "size: 0.12")});
  const dem::Model model = dem::read_model(expand_tunnels(scene).scene);
  double lining = 0;  // its area
  for (std::uint32_t i = 0; i < model.discs.size(); ++i)
    if (model.group[i] == 1) lining += model.cell_area(i);
  EXPECT_NEAR(lining, pi * (3.5 * 3.5 - 3 * 3), 1e-9);
}

// Requirement: the section of a lining of cells states its thickness and how its concrete breaks, and places
// its bars under their cover at either face and its stirrups between the covers, no farther apart than
// stated; cuts compare their forces with it.
TEST(ExpandTunnels, ASectionOfCells) {
  const std::string section =
      "section { thickness: 0.5 cover: 0.05 concrete { class: 'C30/37' } steel { class: 'B500B' } inner { "
      "diameter: 0.02 spacing: 0.1 } outer { diameter: 0.016 spacing: 0.2 } stirrups { diameter: 0.01 "
      "spacing: 0.3 "
      "spacing_across: 0.4 } }";
  const auto of_cells = [&](const std::string& shape, const std::string& more) {
    return particles_of("centre { x: 1 y: -12 } " + shape + " lining { " + section + more +
                        " } particles { size: 0.12 ground: 2 overlap: 1 } stage: 1 sections: 4");
  };
  const auto particles = of_cells("circle { radius: 3 }", "");
  const auto& group = particles.groups(particles.groups_size() - 1);
  EXPECT_EQ(group.where().annulus().outer_radius(), 3.5);
  EXPECT_NEAR(group.material().young_modulus(), 32.8e9, 0.1e9);
  EXPECT_EQ(group.material().fracture().compressive_strength(), 38e6);
  EXPECT_NEAR(group.material().fracture().tensile_strength(), 2.9e6, 0.01e6);
  EXPECT_NEAR(group.material().fracture().fracture_energy(), 73 * std::pow(38, 0.18), 1e-9);
  ASSERT_EQ(particles.bars_size(), 2 + 63);  // 6 pi / 0.3 m
  EXPECT_NEAR(particles.bars(0).along().circle().radius(), 3 + 0.05 + 0.01, 1e-12);
  EXPECT_NEAR(particles.bars(1).along().circle().radius(), 3.5 - 0.05 - 0.008, 1e-12);
  EXPECT_NEAR(particles.bars(0).area(), pi / 4 * 0.0004 / 0.1, 1e-12);
  for (const auto& bar : particles.bars()) EXPECT_EQ(bar.stage(), 2U);
  const auto& stirrup = particles.bars(2).along().line();
  EXPECT_NEAR(std::hypot(stirrup.points(0).x() - 1, stirrup.points(0).y() + 12), 3.05, 1e-12);
  EXPECT_NEAR(std::hypot(stirrup.points(1).x() - 1, stirrup.points(1).y() + 12), 3.45, 1e-12);
  EXPECT_NEAR(particles.bars(2).area(), pi / 4 * 0.0001 / 0.4, 1e-12);
  EXPECT_EQ(particles.sections(3).section().outer().spacing(), 0.2);
  const auto use = std::ranges::count(particles.histories(), scene::UTILISATION, &scene::History::quantity);
  EXPECT_EQ(use, 4);

  const auto segments = of_cells("circle { radius: 3 }", " segments: 3");
  ASSERT_EQ(segments.bars_size(), 2 * 3 + 3 * 21);
  const auto& arc = segments.bars(0).along().circle();
  EXPECT_NEAR((arc.to() - arc.from()) * arc.radius(), 2 * pi / 3 * 3.06 - 2 * 0.05, 1e-9);

  const auto box = of_cells("box { width: 5 height: 4 }", "");
  ASSERT_EQ(box.bars_size(), 4 + 1 + 60);  // inner bars run straight to the other side's cover
  const auto& wall = box.bars(0).along().line();
  ASSERT_EQ(wall.points_size(), 2);
  EXPECT_NEAR(wall.points(0).x(), 1 + 2.5 + 0.06, 1e-12);
  EXPECT_NEAR(wall.points(0).y(), -12 - 2 - 0.5 + 0.05, 1e-12);
  EXPECT_NEAR(wall.points(1).y(), -12 + 2 + 0.5 - 0.05, 1e-12);
  const auto& outer = box.bars(4).along().line();
  ASSERT_EQ(outer.points_size(), 5);
  EXPECT_EQ(outer.points(0).x(), outer.points(4).x());
  EXPECT_EQ(of_cells("horseshoe { width: 5 height: 4.5 }", "").bars(2).along().line().points_size(), 52);
}

// Requirement: the ground's cells may be larger than the lining's.
TEST(ExpandTunnels, LargerCellsInTheGround) {
  const auto wanted = test::replaced(test::circular(), "radius: 0.05", "size: 0.12 ground_size: 0.4");
  const auto cells = particles_of(wanted).cells();
  EXPECT_EQ(cells.size(), 0.4);
  ASSERT_EQ(cells.finer_size(), 1);
  EXPECT_EQ(cells.finer(0).size(), 0.12);
  EXPECT_EQ(cells.finer(0).where().annulus().inner_radius(), 3);
  EXPECT_EQ(cells.finer(0).where().annulus().outer_radius(), 3.5);
  const auto number = [](const std::string& tunnel) {
    return dem::read_model(expand_tunnels(test::scene_with({tunnel})).scene).discs.size();
  };
  EXPECT_LT(2 * number(wanted), number(test::replaced(test::circular(), "radius: 0.05", "size: 0.12")));
}

// Requirement: the overlap ends where the particles end, and leaves ground between itself and the lining.
TEST(ExpandTunnels, TheOverlapLiesInTheOuterGround) {
  const Expansion expansion = expand_tunnels(test::scene_with({test::circular()}));
  const auto& overlap = expansion.scene.interface().overlap();
  EXPECT_EQ(overlap.around().circle().radius(), 4.5);
  EXPECT_EQ(overlap.width(), 1);
  EXPECT_EQ(expansion.scene.interface().inner(), "particles");
}

// Requirement: joints run across the lining at equal angles from the first; bolts, gaskets and keys cross
// them in the middle, from the clockwise to the counter-clockwise side.
TEST(ExpandTunnels, SegmentsWithBoltsGasketsAndKeys) {
  const auto particles = particles_of(test::circular(
      "segments: 6 first_joint: 0.5 bolts { length: 0.6 stiffness: 2e8 strength: 3e5 } gasket { opening: "
      "-0.1 opening: 0 force: -2e5 force: -1e5 } keys { stiffness: 1e9 clearance: 0.01 }"));
  ASSERT_EQ(particles.joints_size(), 6);
  ASSERT_EQ(particles.springs_size(), 18);
  for (int k = 0; k < 6; ++k) {
    const double angle = 0.5 + k * pi / 3, c = std::cos(angle), s = std::sin(angle);
    const auto& joint = particles.joints(k);
    EXPECT_EQ(joint.name(), "tunnel_joint_" + std::to_string(k + 1));
    EXPECT_TRUE(joint.open());
    expect_point(joint.from(), 1 + 2.95 * c, -12 + 2.95 * s);
    expect_point(joint.to(), 1 + 3.5 * c, -12 + 3.5 * s);
    const auto &bolt = particles.springs(3 * k), &gasket = particles.springs(3 * k + 1),
               &key = particles.springs(3 * k + 2);
    EXPECT_EQ(bolt.name(), "tunnel_bolt_" + std::to_string(k + 1));
    expect_point(bolt.from(), 1 + 3.25 * c + 0.3 * s, -12 + 3.25 * s - 0.3 * c);
    expect_point(bolt.to(), 1 + 3.25 * c - 0.3 * s, -12 + 3.25 * s + 0.3 * c);
    EXPECT_TRUE(bolt.tension_only());
    EXPECT_EQ(bolt.strength(), 3e5);
    EXPECT_EQ(gasket.name(), "tunnel_gasket_" + std::to_string(k + 1));
    EXPECT_FALSE(gasket.tension_only());
    EXPECT_EQ(gasket.curve().force(0), -2e5);
    expect_point(gasket.direction(), -s, c);
    EXPECT_EQ(key.clearance(), 0.01);
    expect_point(key.direction(), c, s);
  }
}

// Requirement: the neighbours are springs along the lining, one a row, that act alike in both directions.
// They resist the rotation of a joint by the stated stiffness, and stay out of its offset.
TEST(ExpandTunnels, NeighboursResistTheRotationOfAJoint) {
  const auto particles =
      particles_of(test::circular("joints: 0.5 neighbours { rotational_stiffness: 4e7 }", "stage: 1"));
  ASSERT_EQ(particles.springs_size(), 15);  // three in each of 5 rows of 8.7 cm
  const double c = std::cos(0.5), s = std::sin(0.5);
  double turning = 0, force = 0;
  for (const auto& spring : particles.springs()) {
    EXPECT_FALSE(spring.tension_only());
    EXPECT_EQ(spring.stage(), 2u);
    expect_point(spring.direction(), -s, c);
    const double x = (spring.from().x() + spring.to().x()) / 2 - 1,
                 y = (spring.from().y() + spring.to().y()) / 2 + 12;
    EXPECT_NEAR(-s * x + c * y, 0, 1e-12);  // crosses the joint in its middle
    const double arm = c * x + s * y - 3.25;
    EXPECT_LE(std::abs(arm), 0.25 - 1.155 * 0.05);
    turning += spring.stiffness() * arm * arm;
    force += spring.stiffness() * arm;
  }
  EXPECT_NEAR(turning, 4e7, 1);
  EXPECT_NEAR(force, 0, 1);
}

TEST(ExpandTunnels, JointsAtTheirOwnAngles) {
  const auto particles = particles_of(test::circular("joints: 0.2 joints: 2.5 joints: 4.5"));
  ASSERT_EQ(particles.joints_size(), 3);
  expect_point(particles.joints(1).to(), 1 + 3.5 * std::cos(2.5), -12 + 3.5 * std::sin(2.5));
}

// Requirement: every named part has its histories, and the inner side its displacements.
TEST(ExpandTunnels, HistoriesOfEveryPart) {
  const auto particles = particles_of(
      test::circular("segments: 2 bolts { length: 0.6 stiffness: 2e8 }", "name: 'left' sections: 4"));
  std::multiset<std::string> names;
  for (const auto& history : particles.histories()) names.insert(history.name());
  for (const char* name : {"left_crown", "left_invert", "left_left", "left_right"})
    EXPECT_EQ(names.count(name), 2u);
  for (const char* name : {"left_joint_1", "left_joint_2", "left_section_1", "left_section_4"})
    EXPECT_EQ(names.count(name), 3u);
  EXPECT_EQ(names.count("left_bolt_2"), 1u);
  EXPECT_EQ(names.count("left"), 3u);  // of the diameters
  EXPECT_EQ(names.size(), 8u + 2 * 3 + 4 * 3 + 2 + 3);
  expect_point(particles.histories(0).at(), 1, -12 + 3.05);
}

// Requirement: the lining of a circle bends as the solid, and its sections have their middle in that of the
// lining.
TEST(ExpandTunnels, ARingIsAsStiffAsItsThickness) {
  const auto particles = particles_of(test::circular("", "sections: 2"));
  EXPECT_TRUE(particles.groups(0).bends_as_solid());
  ASSERT_EQ(particles.sections_size(), 2);
  for (const auto& section : particles.sections())
    EXPECT_NEAR(std::abs(section.from().x() + section.to().x() - 2) / 2, 3.25, 1e-12);
  ASSERT_EQ(particles.ovals_size(), 1);
  EXPECT_EQ(particles.ovals(0).annulus().outer_radius(), 3.5);
  const auto box =
      particles_of(test::replaced(test::circular(), "circle { radius: 3 }", "box { width: 6 height: 4 }"));
  EXPECT_FALSE(box.groups(0).bends_as_solid());
  EXPECT_EQ(box.ovals_size(), 0);
}

// Requirement: with a stage the particles fill the tunnel until it is excavated; the lining comes one stage
// later.
TEST(ExpandTunnels, AStageOfExcavation) {
  const auto particles = particles_of(
      test::circular("segments: 2 bolts { length: 0.6 stiffness: 2e8 }", "stage: 2 released: 0.4"));
  EXPECT_EQ(particles.within().circle().radius(), 5.5);
  ASSERT_EQ(particles.excavations_size(), 1);
  EXPECT_EQ(particles.excavations(0).where().circle().radius(), 3.5);
  EXPECT_EQ(particles.excavations(0).stage(), 2u);
  EXPECT_EQ(particles.excavations(0).released(), 0.4);
  EXPECT_EQ(particles.groups(0).where().annulus().inner_radius(), 3);
  EXPECT_EQ(particles.groups(0).stage(), 3u);
  EXPECT_EQ(particles.springs(0).stage(), 3u);
  EXPECT_FALSE(particles.joints(0).has_stage());  // it begins to act with the lining
  EXPECT_EQ(particles_of(test::circular("", "stage: 1")).groups(0).stage(), 2u);
  EXPECT_FALSE(particles_of(test::circular()).groups(0).has_stage());
}

// Requirement: a material with Mohr-Coulomb gives the strengths of the bonds, unless they have their own.
TEST(ExpandTunnels, StrengthOfTheLining) {
  const auto strong = [](const std::string& lining) {
    return test::replaced(test::circular(lining), "density: 2500",
                          "density: 2500 mohr_coulomb { cohesion: 4e6 friction_angle: 0.8 tension: 2e6 }");
  };
  EXPECT_TRUE(particles_of(strong("")).groups(0).bonds().strength_of_material());
  const auto given = particles_of(strong("bonds { tensile_strength: 1e5 }"));
  EXPECT_EQ(given.groups(0).bonds().tensile_strength(), 1e5);
  EXPECT_FALSE(given.groups(0).bonds().strength_of_material());
}

// Requirement: several tunnels become regions, each joined to the continuum.
TEST(ExpandTunnels, TwoTunnels) {
  const Expansion expansion = expand_tunnels(
      test::scene_with({test::circular("", "name: 'left'"),
                        test::replaced(test::circular("", "name: 'right'"), "x: 1", "x: 12")}));
  protocol::check_rules(expansion.scene);
  const auto& scene = expansion.scene;
  EXPECT_FALSE(scene.has_particles());
  EXPECT_FALSE(scene.has_interface());
  ASSERT_EQ(scene.regions_size(), 2);
  EXPECT_EQ(scene.regions(1).name(), "right");
  EXPECT_EQ(scene.regions(1).particles().groups(0).name(), "right");
  EXPECT_EQ(scene.interfaces(1).inner(), "right");
  EXPECT_EQ(scene.interfaces(1).outer(), "continuum");
  EXPECT_EQ(joins(scene, members(scene)).size(), 2u);
}

// Requirement: the lattice is its own mirror image about both axes of the tunnel and fills the area around
// it.
TEST(ExpandTunnels, TheLatticeIsSymmetric) {
  const scene::Scene scene = expand_tunnels(test::scene_with({test::circular()})).scene;
  const dem::Model model = dem::read_model(part_of(scene, members(scene)[1]));
  const auto key = [](double x, double y) { return std::pair(std::lround(x * 1e6), std::lround(y * 1e6)); };
  std::set<std::pair<long, long>> places;
  for (std::size_t i = 0; i < model.discs.size(); ++i)
    places.insert(key(model.discs.x[i] - 1, model.discs.y[i] + 12));
  for (const auto& [x, y] : places) {
    EXPECT_TRUE(places.contains({-x, y}));
    EXPECT_TRUE(places.contains({x, -y}));
  }
  const double area = 2 * std::numbers::sqrt3 * 0.05 * 0.05 * static_cast<double>(model.discs.size());
  EXPECT_NEAR(area, pi * (5.5 * 5.5 - 3 * 3), 0.01 * area);
}

// Requirement: a tunnel has the same lattice wherever it lies, also where whole radii fill its box exactly
// and only rounding could say whether there is room for one more.
TEST(ExpandTunnels, TheLatticeIsTheSameAnywhere) {
  const auto half_sizes = [](double x, double y) {
    const std::string tunnel = test::replaced(test::circular(), "x: 1 y: -12",
                                              "x: " + std::to_string(x) + " y: " + std::to_string(y));
    const auto& packing = expand_tunnels(test::scene_with({tunnel})).scene.particles().packing();
    return std::pair((packing.x_max() - packing.x_min()) / 2, (packing.y_max() - packing.y_min()) / 2);
  };
  const auto [width, height] = half_sizes(0, 0);
  for (int k = 1; k <= 200; ++k) {
    const auto [w, h] = half_sizes(0.37 * k, -11.3 * k);
    EXPECT_NEAR(w, width, 1e-9) << k;
    EXPECT_NEAR(h, height, 1e-9) << k;
  }
}

// Requirement: what a tunnel became can be set up.
TEST(ExpandTunnels, ATunnelOfEachShapeIsSetUp) {
  for (const char* shape :
       {"circle { radius: 3 }", "horseshoe { width: 6 height: 5 }", "box { width: 6 height: 4 }"}) {
    const std::string tunnel =
        test::replaced(test::circular("", "sections: 0"), "circle { radius: 3 }", shape);
    const Model model = test::local_model(expand_tunnels(test::scene_with({tunnel})).scene);
    EXPECT_FALSE(model.coupling_points.empty()) << shape;
  }
}

TEST(ExpandTunnels, AThinLiningIsNoted) {
  const auto notes = [](const char* radius, const char* shape) {
    const std::string tunnel = test::replaced(test::circular(), "radius: 0.05", radius);
    return expand_tunnels(test::scene_with({test::replaced(tunnel, "circle { radius: 3 }", shape)})).notes;
  };
  const char *ring = "circle { radius: 3 }", *box = "box { width: 6 height: 4 }";
  EXPECT_THAT(notes("radius: 0.04", ring), IsEmpty());  // 7 rows of 6.9 cm
  EXPECT_THAT(notes("radius: 0.08", ring),
              ElementsAre(AllOf(HasSubstr("tunnel: 3 rows of particles lie over the lining's thickness"),
                                HasSubstr("gives 7"))));
  EXPECT_THAT(notes("radius: 0.05", box), IsEmpty());  // 5 rows of 8.7 cm
  EXPECT_THAT(notes("radius: 0.08", box), ElementsAre(HasSubstr("gives 5")));
}

void expect_refused(const std::string& tunnel, const std::string& path, const std::string& text) {
  test::expect_refusal([&] { expand_tunnels(test::scene_with({tunnel})); }, path, text);
}

TEST(ExpandTunnels, WhatCannotBeBuiltIsRefused) {
  expect_refused(
      test::replaced(test::circular("segments: 4"), "circle { radius: 3 }", "box { width: 6 height: 4 }"),
      "tunnels[0].lining.segments", "only the lining of a circle has segments");
  expect_refused(test::circular("bolts { length: 0.6 stiffness: 2e8 }"), "tunnels[0].lining.bolts",
                 "the lining has no joints; give `segments` or `joints`");
  expect_refused(test::circular("gasket { opening: 0 opening: 1 force: 0 force: 1 }"),
                 "tunnels[0].lining.gasket", "has no joints");
  expect_refused(test::circular("neighbours { rotational_stiffness: 1 }"), "tunnels[0].lining.neighbours",
                 "has no joints");
  expect_refused(test::circular("keys { stiffness: 1 }"), "tunnels[0].lining.keys", "has no joints");
  expect_refused(test::replaced(test::circular(), "radius: 0.05", ""), "tunnels[0].particles",
                 "needs size or radius; give `size` for cells");
  expect_refused(test::replaced(test::circular(), "radius: 0.05", "radius: 0.05 size: 0.1"),
                 "tunnels[0].particles", "has size and radius");
  expect_refused(test::replaced(test::circular(), "radius: 0.05", "radius: 0.05 ground_size: 0.4"),
                 "tunnels[0].particles.ground_size", "is of cells, but `radius` asks for discs; give `size`");
  expect_refused(test::replaced(test::replaced(test::circular(), "radius: 0.05", "size: 0.3"),
                                "circle { radius: 3 }", "box { width: 6 height: 4 }"),
                 "tunnels[0].particles.size",
                 "is 0.3 m, more than half of the lining's thickness; give at most 0.25 m");
  expect_refused(test::circular("segments: 3 joints: 0.1"), "tunnels[0].lining.joints",
                 "is given beside `segments`");
  scene::Scene nowhere = test::scene_with({test::circular()});
  nowhere.clear_continuum();
  test::expect_refusal([&] { expand_tunnels(nowhere); }, "tunnels", "lie in no ground");
  scene::Scene scattered = test::scene_with({test::circular()});
  scattered.mutable_continuum()->add_scatter()->set_path("field.csv");
  for (const auto as : {scene::TunnelLining::PARTICLES, scene::TunnelLining::ZONES}) {
    scattered.mutable_tunnels(0)->mutable_lining()->set_as(as);
    test::expect_refusal(
        [&] { expand_tunnels(scattered); }, "tunnels[0].lining.as",
        "is not beam, but `continuum.scatter` would scatter the zones or particles of the lining");
  }
}

scene::Scene layered(const std::string& where, const std::string& tunnel) {
  scene::Scene scene = test::scene_with({tunnel});
  EXPECT_TRUE(google::protobuf::TextFormat::MergeFromString(
      "continuum { materials { where { " + where +
          " } material { young_modulus: 1e8 poisson_ratio: 0.2 density: 1800 "
          "mohr_coulomb { cohesion: 1e4 } } } }",
      &scene));
  return scene;
}

// Requirement: the ground around a tunnel is that of the zones whose place it takes: their own material, and
// groups for others that reach into it, below the tunnel's own groups. What the tunnel states holds instead.
TEST(ExpandTunnels, GroundOfTheZones) {
  const auto particles = expand_tunnels(layered("y_min: -10", test::circular())).scene.particles();
  ASSERT_EQ(particles.groups_size(), 2);
  EXPECT_EQ(particles.groups(0).name(), "tunnel_ground_1");
  EXPECT_EQ(particles.groups(0).where().y_min(), -10);
  EXPECT_EQ(particles.groups(0).material().young_modulus(), 1e8);
  EXPECT_FALSE(particles.groups(0).material().has_mohr_coulomb());  // bonds that do not break
  EXPECT_EQ(particles.groups(1).name(), "tunnel");
  EXPECT_EQ(particles.between_size(), 2);  // of the lining with either ground
  EXPECT_EQ(expand_tunnels(layered("y_min: -6", test::circular())).scene.particles().groups_size(), 1);
  EXPECT_EQ(expand_tunnels(layered("circle { centre { x: 1 y: -12 } radius: 2 }", test::circular()))
                .scene.particles()
                .groups_size(),
            1);
  EXPECT_EQ(
      expand_tunnels(layered("circle { centre { x: 1 y: -12 } radius: 2 }", test::circular("", "stage: 1")))
          .scene.particles()
          .groups_size(),
      2);  // it is there until it is excavated

  const std::string own =
      test::replaced(test::circular(), "overlap: 1",
                     "overlap: 1 material { young_modulus: 2e9 poisson_ratio: 0.2 density: 2000 }");
  EXPECT_EQ(expand_tunnels(layered("y_min: -10", own)).scene.particles().groups_size(), 1);

  scene::Scene scene = test::scene_with({test::circular()});
  *scene.mutable_continuum()->mutable_material() = scene.material();
  scene.mutable_continuum()->mutable_material()->set_young_modulus(5e8);
  EXPECT_EQ(expand_tunnels(scene).scene.particles().material().young_modulus(), 5e8);
}

// Requirement: ground that a region cannot take over is refused at its zones, with the tunnel's remedy.
TEST(ExpandTunnels, GroundThatBondsCannotHave) {
  const auto error = expand_tunnels(layered("y_min: -10", test::circular()))
                         .at_tunnel({"particles.groups[0].material.poisson_ratio", "is 0.4"});
  EXPECT_EQ(error.path(), "continuum.materials[0]");
  EXPECT_THAT(error.what(), AllOf(HasSubstr("`particles.groups[0].material.poisson_ratio` in `tunnels[0]`"),
                                  HasSubstr("or state the ground by `particles.material` of the tunnel")));
}

// Requirement: particles keep their material, so that zones whose place they take must, too.
TEST(ExpandTunnels, GroundThatChangesInAStage) {
  scene::Scene scene = layered("y_min: -10", test::circular());
  scene.mutable_continuum()->mutable_materials(0)->set_stage(1);
  test::expect_refusal([&] { expand_tunnels(scene); }, "continuum.materials[0].stage",
                       "is 1, but the area reaches into the particles of tunnel");
  scene.mutable_continuum()->mutable_materials(0)->mutable_where()->set_y_min(-6);
  EXPECT_EQ(expand_tunnels(scene).scene.particles().groups_size(), 1);
}

// Requirement: every particle of the ground has the material of the zone at its place, thin layers included
// as far as particles can show them.
TEST(ExpandTunnels, EveryParticleHasTheGroundOfItsPlace) {
  for (const char* where : {"y_min: -10", "band { from { x: -10 y: -8 } to { x: 10 y: -9 } width: 0.6 }",
                            "x_max: -4.3", "x_min: -4.45 x_max: -4.3"}) {
    scene::Scene scene = expand_tunnels(layered(where, test::circular())).scene;
    const dem::Model model = dem::read_model(scene);
    const protocol::Places soft(scene.particles().groups(0).where(), "where", 1e-9);
    std::size_t there = 0;
    for (std::size_t i = 0; i < model.discs.size(); ++i) {
      if (model.group_names[model.group[i]] == "tunnel") continue;
      EXPECT_EQ(soft.hold(model.discs.x[i], model.discs.y[i]), model.density[model.group[i]] == 1800);
      there += model.density[model.group[i]] == 1800;
    }
    EXPECT_GT(there, 0u) << where;
  }
}

// Requirement: what is refused of the expansion is told at the tunnel, with the place in the expansion.
TEST(ExpandTunnels, RefusalsComeBackToTheTunnel) {
  const Expansion expansion = expand_tunnels(test::scene_with({test::circular()}));
  const auto error = expansion.at_tunnel({"particles.groups[0].where", "selects no particles; widen it"});
  EXPECT_EQ(error.path(), "tunnels[0]");
  EXPECT_STREQ(error.what(), "becomes `particles.groups[0].where`, which selects no particles; widen it");
  EXPECT_EQ(expansion.at_tunnel({"continuum.block", "is empty"}).path(), "continuum.block");
}

}  // namespace
}  // namespace adit::coupler::expand_test

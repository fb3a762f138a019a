// Cells of broken bodies meet as polygons: what they have in common, the forces by it, and what these keep.
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "dem_server/engines/general/polygons/depth.hpp"
#include "dem_server/engines/general/polygons/overlap.hpp"
#include "dem_server/engines/general/renumber.hpp"
#include "dem_server/model/reading/read_model.hpp"
#include "tests/unit/dem_server/discs_models.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::cell_contacts_test {
namespace {

using Polygon = std::vector<geometry::Point>;

Polygon rectangle(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

// A convex polygon about (0, 0): its corners lie on a circle.
Polygon random_polygon(std::mt19937& generator, double radius) {
  const int corners = 3 + static_cast<int>(generator() % 6);
  Polygon polygon;
  for (int k = 0; k < corners; ++k) {
    const double angle =
        2 * std::numbers::pi * (k + 0.8 * static_cast<double>(generator()) / std::mt19937::max()) / corners;
    polygon.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return polygon;
}

Polygon moved(const Polygon& polygon, double x, double y, double turn) {
  Polygon at;
  for (const auto& corner : polygon)
    at.push_back({x + std::cos(turn) * corner.x - std::sin(turn) * corner.y,
                  y + std::sin(turn) * corner.x + std::cos(turn) * corner.y});
  return at;
}

// Two cells of these outlines, each about its own (0, 0), the second at (x, y).
Model two_cells(const std::array<Polygon, 2>& outlines, double x, double y, const LinearContact& law) {
  Model model = test::loose_discs({{0, 0, 0.1}, {x, y, 0.1}}, law);
  model.outlines = {outlines[0], outlines[1]};
  model.gyration_square = {0.2, 0.2};
  model.cell_elasticity = {{1e9, 0}};
  model.mass = {test::kSolidDensity, test::kSolidDensity};
  return model;
}

// Of a wall that lies along a side, through a corner, outside, and with its end in a square of the side 1.
TEST(Depth, OfAWallInASquare) {
  const Polygon square = rectangle(0, 0, 1, 1);
  EXPECT_EQ(depth_of({-1, 0}, {2, 0}, square, 0).stored, 0);
  EXPECT_EQ(depth_of({-1, 1}, {1, -1}, square, 0).stored, 0);
  EXPECT_EQ(depth_of({-1, -0.1}, {2, -0.1}, square, 0).stored, 0);
  const Depth end = depth_of({0.5, -1}, {0.5, 0.1}, square, 0);
  EXPECT_NEAR(end.stored, 0.1 * 0.1 * 0.1 / 6, 1e-15);
  EXPECT_NEAR(end.pushing, 0.1 * 0.1 / 2, 1e-15);
  EXPECT_NEAR(end.ny, -1, 1e-15);
  const Depth flat = depth_of({-1, 0.1}, {2, 0.1}, square, 0.05);
  EXPECT_NEAR(flat.pushing, 0.05 * (1 - 2 * 0.1), 1e-15)
      << "between the corners, where other sides are nearer";
  EXPECT_NEAR(flat.x, 0.5, 1e-15);
  EXPECT_NEAR(largest_depth({-1, 0.1}, {2, 0.1}, square), 0.1, 1e-15);
}

// However shallow it lies, turned or not, all that a wall stores is what a side as long as the chord stores.
TEST(Depth, IsNowhereMoreThanBelowTheChord) {
  std::mt19937 generator(11);
  for (int k = 0; k < 20000; ++k) {
    const double turn = 1e-9 * static_cast<double>(generator() % 1000),
                 deep = 1e-12 * static_cast<double>(generator() % 100000);
    const Polygon square = moved(rectangle(-0.5, 0, 1, 1), 0.1, 0, turn);
    const double deepest = deep + std::sin(turn);
    EXPECT_LE(depth_of({-9, deep}, {9, deep}, square, 0).stored, 0.5 * deepest * deepest * (1 + 1e-6)) << k;
  }
}

// A square of the side 1 above a wall on which it lies.
Model cell_on_wall(const LinearContact& law) {
  Model model = two_cells({rectangle(-0.5, -0.5, 1, 1), rectangle(-0.5, -0.5, 1, 1)}, 50, 50, law);
  model.walls = {test::wall(-9, -0.5, 9, -0.5, law)};
  return model;
}

// Two squares that lie in each other by a tenth of their sides.
TEST(Overlap, OfTwoSquares) {
  OverlapWork work;
  const Overlap common = overlap_of(rectangle(0, 0, 1, 1), rectangle(0.9, 0.25, 1, 1), work);
  EXPECT_NEAR(common.area, 0.1 * 0.75, 1e-15);
  EXPECT_NEAR(common.chord, std::hypot(0.1, 0.75), 1e-15);
  EXPECT_NEAR(common.nx, 0.75 / common.chord, 1e-14);
  EXPECT_NEAR(common.ny, 0.1 / common.chord, 1e-14);
  EXPECT_EQ(overlap_of(rectangle(0, 0, 1, 1), rectangle(1, 0, 1, 1), work).area, 0);
  EXPECT_EQ(overlap_of(rectangle(0, 0, 1, 1), rectangle(3, 0, 1, 1), work).area, 0);
  EXPECT_EQ(overlap_of(rectangle(0, 0, 1, 1), rectangle(0.25, 0.25, 0.5, 0.5), work).area, 0)
      << "what lies inside the other whole is pushed nowhere";
}

// The area grows as the second polygon moves and turns by minus chord times the normal, and its moment; so
// for polygons that cross twice or more often.
TEST(Overlap, GrowsByItsChord) {
  std::mt19937 generator(5);
  OverlapWork work;
  int seen = 0;
  for (int k = 0; k < 400; ++k) {
    const Polygon first = random_polygon(generator, 1), second = random_polygon(generator, 1);
    const double x = 1.5 * static_cast<double>(generator()) / std::mt19937::max(), y = 0.3, turn = 0.1 * k;
    const Overlap common = overlap_of(first, moved(second, x, y, turn), work);
    if (common.area < 1e-3) continue;
    ++seen;
    const double small = 1e-6;
    const auto growth = [&](double dx, double dy, double dturn) {
      return (overlap_of(first, moved(second, x + dx, y + dy, turn + dturn), work).area -
              overlap_of(first, moved(second, x - dx, y - dy, turn - dturn), work).area) /
             (2 * small);
    };
    EXPECT_NEAR(growth(small, 0, 0), -common.chord * common.nx, 1e-5);
    EXPECT_NEAR(growth(0, small, 0), -common.chord * common.ny, 1e-5);
    EXPECT_NEAR(growth(0, 0, small),
                -common.chord * ((common.x - x) * common.ny - (common.y - y) * common.nx), 1e-5);
  }
  EXPECT_GT(seen, 200);
}

struct Momenta {
  double x, y, turning;
};

Momenta momenta(const Particles& p) {
  Momenta sum{};
  for (int i : {0, 1}) {
    sum.x += p.mass[i] * p.vx[i];
    sum.y += p.mass[i] * p.vy[i];
    sum.turning +=
        p.mass[i] * ((p.x[i] + p.ux[i]) * p.vy[i] - (p.y[i] + p.uy[i]) * p.vx[i]) + p.inertia[i] * p.spin[i];
  }
  return sum;
}

// Two cells fly at each other, turning; their momenta stay to rounding, and without friction their energy by
// the second order of the step.
TEST(CellContacts, KeepMomentaAndEnergy) {
  std::mt19937 generator(7);
  for (int k = 0; k < 20; ++k) {
    const std::array outlines{random_polygon(generator, 1), random_polygon(generator, 1)};
    const double offset = 1.2 * static_cast<double>(generator()) / std::mt19937::max() - 0.6;
    for (const int fine : {0, 1}) {
      test::Run run(two_cells(outlines, 2.2, offset, {1e9, 3e8, 0.0}), fine ? 2.5e-6 : 1e-5);
      Particles& p = run.solver.particles();
      p.vx = {20, -30};
      p.vy = {3, -4};
      p.spin = {5, -8};
      const Momenta before = momenta(p);
      run.step();
      const double energy = run.kinetic();
      run.steps(fine ? 16000 : 4000);
      const Momenta after = momenta(p);
      EXPECT_NEAR(after.x, before.x, 1e-9 * p.mass[0]);
      EXPECT_NEAR(after.y, before.y, 1e-9 * p.mass[0]);
      EXPECT_NEAR(after.turning, before.turning, 1e-9 * p.mass[0]);
      EXPECT_LT(p.vx[0], 20) << "they met";
      EXPECT_NEAR((run.kinetic() + run.solver.strain_energy().sum()) / energy, 1, fine ? 1e-6 : 2e-5) << k;
    }
  }
}

// A square lies flatly on a wall: it is as deep in it as a spring of the law's stiffness, times its side over
// that of a regular hexagon of its area, is shortened by its weight. At both ends of the side, on a length as
// large as the depth, the other sides are nearer.
TEST(CellContacts, OfAFlatSideOnAWall) {
  const double g = 10, stiffness = 1e9;
  const LinearContact law{stiffness, stiffness, 0.4};
  Model model = cell_on_wall(law);
  model.local_damping = 0.5;
  test::add_gravity(model, -g);
  const double dt = 0.5 * critical_step(model);
  Solver solver(model, 1);
  Loads gravity(model, solver.particles());
  PrescribedMotions none(model, solver.particles());
  for (std::uint64_t n = 1; n < 3000; ++n) solver.step({n, dt}, gravity, none);
  const double side = 1 / std::sqrt(1.5 * std::numbers::sqrt3);  // 1.5 sqrt(3) side^2 = 1
  const double depth = -solver.particles().uy[0];
  EXPECT_NEAR(depth * (1 - 2 * depth), test::kSolidDensity * g * side / stiffness, 1e-8 * depth);
  EXPECT_NEAR(solver.walls().force(0).y, -test::kSolidDensity * g, 1e-6 * test::kSolidDensity * g);
}

// It slides v^2 / (2 mu g) until friction stops it, and does not topple.
TEST(CellContacts, FrictionStopsASlidingSquare) {
  const double g = 10, mu = 0.4, speed = 0.5;
  Model model = cell_on_wall({1e9, 1e9, mu, 0.5, 0.5});
  test::add_gravity(model, -g);
  const double dt = 0.2 * critical_step(model);
  Solver solver(model, 1);
  Particles& p = solver.particles();
  Loads gravity(model, p);
  PrescribedMotions none(model, p);
  p.vx[0] = speed;
  const double way = speed * speed / (2 * mu * g);
  for (std::uint64_t n = 1; static_cast<double>(n) * dt < 2 * speed / (mu * g); ++n)
    solver.step({n, dt}, gravity, none);
  EXPECT_NEAR(p.ux[0], way, 0.01 * way);
  EXPECT_NEAR(p.vx[0], 0, 0.01 * speed);
  EXPECT_NEAR(solver.facets().set().turn[0], 0, 1e-4);
}

// Requirement: a polygon that falls on a wall with any turn, on its side or on its end, keeps its energy
// without friction, by the second order of the step.
TEST(CellContacts, KeepEnergyOnAWall) {
  std::mt19937 generator(3);
  for (int k = 0; k < 10; ++k) {
    Model model = two_cells({random_polygon(generator, 1), random_polygon(generator, 1)}, 50, 0, {1e9, 0, 0});
    model.walls = {k % 2 == 0 ? test::wall(-9, -1.2, 9, -1.2, {1e9, 0, 0})
                              : test::wall(0.1 * (k - 5), -9, 0.1 * (k - 5), -1.2, {1e9, 0, 0})};
    for (const int fine : {0, 1}) {
      test::Run run(model, fine ? 2.5e-6 : 1e-5);
      Particles& p = run.solver.particles();
      p.vy[0] = -20;
      p.spin[0] = 0.5 * (k - 5);
      run.step();
      const double energy = run.kinetic();
      run.steps(fine ? 16000 : 4000);
      EXPECT_GT(std::abs(p.vy[0] + 20), 1) << "they met";
      EXPECT_NEAR((run.kinetic() + run.solver.strain_energy().sum()) / energy, 1, fine ? 1e-6 : 2e-5) << k;
    }
  }
}

// Dashpots and stiff contacts shorten the step of cells, and a group without any of them changes nothing.
TEST(CellContacts, ShortenTheStepWhereTheyAreStifferThanFacets) {
  const auto step = [](const char* contacts, const char* group) {
    auto scene = test::empty_scene();
    EXPECT_TRUE(google::protobuf::TextFormat::MergeFromString(
        std::string("particles { cells { x_min: 0 x_max: 1 y_min: 0 y_max: 1 size: 0.2 } bonds {} ") +
            contacts + group + "}",
        &scene));
    return critical_step(read_model(scene));
  };
  const char* all = "groups { name: \"all\" where { x_min: -1 } contacts { friction: 0.1 } }";
  const double plain = step("", "");
  EXPECT_EQ(step("", all), plain);
  const double damped = step("contacts { normal_damping: 0.2 }", "");
  EXPECT_LT(damped, 0.9 * plain);
  EXPECT_GT(damped, 0.3 * plain);
  EXPECT_NEAR(step("contacts { normal_damping: 0.2 }", all), plain, 1e-6 * plain);
  // Of nine times the stiffness of a facet of a regular hexagon.
  const auto elastic = test::empty_scene().material();
  const double facet =
      elastic.young_modulus() / (1 - elastic.poisson_ratio() * elastic.poisson_ratio()) / std::sqrt(3);
  EXPECT_LT(step(("contacts { normal_stiffness: " + std::to_string(9 * facet) + " }").c_str(), ""),
            0.4 * plain);
}

// Cells slide along a smooth joint by more than their size, under pressure: what is theirs to bear there is
// the joint's, so that none of them touch.
TEST(CellContacts, LeaveSmoothJointsAlone) {
  auto scene = test::empty_scene();
  ASSERT_TRUE(google::protobuf::TextFormat::MergeFromString(R"(particles {
    cells { x_min: 0 x_max: 1 y_min: 0 y_max: 0.6 size: 0.1 }
    contacts { friction: 1 }
    bonds {}
    joints { from { x: 0 y: 0.3 } to { x: 1 y: 0.3 }
             smooth { normal_stiffness: 1e10 shear_stiffness: 1e10 friction: 0.1 } }
    motions { where { y_max: 0.1 } velocity { x: 0 y: 0 } }
    motions { where { y_min: 0.5 } velocity { x: 10 y: -0.01 } }
  })",
                                                            &scene));
  Model model = read_model(scene);
  renumber(model);
  const double dt = 0.5 * critical_step(model);
  Solver solver(model, 1);
  Loads none(model, solver.particles());
  PrescribedMotions motions(model, solver.particles());
  double pressed = 0;
  for (std::uint64_t n = 1; static_cast<double>(n) * dt < 0.015; ++n) {
    solver.step({n, dt}, none, motions);
    for (const auto& contact : solver.cells().contacts()) ASSERT_EQ(contact.touch.stiffness, 0) << n;
  }
  for (const Joints::Joint& joint : solver.joints().joints()) pressed += joint.normal;
  EXPECT_LT(pressed, -1e5);
}

// Loose cells that fall into a heap come to rest, lie beside each other and not in each other, and the ledger
// closes.
TEST(CellContacts, AHeapOfRubbleComesToRest) {
  auto scene = test::empty_scene();
  scene.set_plane(scene::PLANE_STRAIN);
  scene.mutable_material()->set_young_modulus(1e8);
  ASSERT_TRUE(google::protobuf::TextFormat::MergeFromString(R"(particles {
    cells { x_min: 0 x_max: 0.5 y_min: 0 y_max: 1 size: 0.1 }
    contacts { friction: 0.3 normal_damping: 0.2 }
    damping { local: 0.2 }
    walls { name: "floor" from { x: -0.2 y: 0 } to { x: 0.7 y: 0 } contacts { friction: 0.3 } }
    walls { name: "left" from { x: -0.2 y: 0 } to { x: -0.2 y: 2 } contacts { friction: 0.3 } }
    walls { name: "right" from { x: 0.7 y: 0 } to { x: 0.7 y: 2 } contacts { friction: 0.3 } }
  })",
                                                            &scene));
  Model model = read_model(scene);
  renumber(model);
  test::add_gravity(model, -9.81);
  const double dt = 0.5 * critical_step(model);
  Solver solver(model, 1);
  const Particles& p = solver.particles();
  Loads gravity(model, solver.particles());
  PrescribedMotions none(model, solver.particles());
  for (std::uint64_t n = 1; static_cast<double>(n) * dt < 2.5; ++n) solver.step({n, dt}, gravity, none);
  double kinetic = 0, top = 0, solid = 0, weight = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    kinetic += p.mass[i] * (p.vx[i] * p.vx[i] + p.vy[i] * p.vy[i]) / 2;
    top = std::max(top, p.y[i] + p.uy[i]);
    solid += model.cell_area(i);
    weight += 9.81 * p.mass[i];
  }
  EXPECT_LT(kinetic, 1e-4 * gravity.work().accelerations);
  EXPECT_LT(top, 0.8) << "it collapsed";
  EXPECT_NEAR(solver.walls().force(0).y, -weight, 0.2 * weight) << "what the sides do not bear";
  int touching = 0;
  double common = 0;
  for (const auto& contact : solver.cells().contacts())
    if (const auto meets = solver.cells().encounter(contact, solver.facets().set(), p)) {
      ++touching;
      common += -meets->gap * 0.1;
    }
  EXPECT_GT(touching, 30);
  EXPECT_LT(common, 0.005 * solid);
  EXPECT_LT(std::abs(solver.time_step_share(solver.strain_energy().sum())),
            0.01 * gravity.work().accelerations);
}

}  // namespace
}  // namespace adit::dem::cell_contacts_test

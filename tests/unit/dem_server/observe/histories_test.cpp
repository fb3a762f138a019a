// Requirements on histories of particles: motions, means over circles, forces on walls.
#include "dem_server/observe/histories.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <functional>

#include "dem_server/engines/general/general_engine.hpp"
#include "dem_server/observe/branches.hpp"
#include "dem_server/observe/fragments.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/dem_server/discs_models.hpp"

namespace adit::dem::histories_test {
namespace {

constexpr double kStiffness = 1e9, kSpacing = 0.99;
constexpr int kSide = 30;
const LinearContact kContact{.normal_stiffness = kStiffness, .shear_stiffness = kStiffness, .friction = 0.5};

// Rows and columns of discs of radius 0.5 m pressed against each other and a wall on their left.
Model pressed_square() {
  std::vector<std::array<double, 3>> discs;
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column) discs.push_back({column * kSpacing, row * kSpacing, 0.5});
  Model model = test::loose_discs(discs, kContact);
  model.overlaps_free = false;
  model.walls.push_back(test::wall(-0.495, -1, -0.495, kSide, kContact));
  return model;
}

scene::History& add(scene::Particles& scene, scene::Quantity quantity, double radius) {
  scene::History& history = *scene.add_histories();
  history.set_name("middle");
  history.set_quantity(quantity);
  history.mutable_at()->set_x(14.3);
  history.mutable_at()->set_y(13.8);
  if (radius > 0) history.set_radius(radius);
  return history;
}

void add_force(scene::Particles& scene, scene::Quantity quantity) {
  scene::History& history = *scene.add_histories();
  history.set_quantity(quantity);
  history.set_wall("wall");
}

// Discs that overlap by 0.01 m press with kn 0.01 m on every 0.99 m; values come in the scene's order,
// motions between them.
TEST(Histories, ReadCirclesAndWalls) {
  scene::Particles scene;
  for (const auto quantity : {scene::STRESS_XX, scene::STRESS_YY, scene::STRESS_XY}) add(scene, quantity, 12);
  add(scene, scene::VELOCITY_X, 0).mutable_at()->set_x(kSpacing);
  for (const auto quantity : {scene::STRAIN_RATE_XX, scene::STRAIN_RATE_YY, scene::SHEAR_STRAIN_RATE_XY,
                              scene::COORDINATION, scene::POROSITY})
    add(scene, quantity, 12);
  add_force(scene, scene::FORCE_X);
  add_force(scene, scene::FORCE_Y);

  GeneralEngine engine(pressed_square(), 1);
  const Lining none;
  Histories histories(scene, engine, none);
  Particles& p = engine.particles();
  histories.remember(p);
  engine.step_interface({1, 1e-9});
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.vx[i] = 2 * p.x[i] + 0.5 * p.y[i];
    p.vy[i] = 0.25 * p.x[i] - 3 * p.y[i];
  }
  histories.remember(p);
  std::vector<double> values;
  histories.read(engine, none, {1, 1e-9}, values);
  ASSERT_EQ(values.size(), 11);
  const double pressure = kStiffness * 0.01 / kSpacing;
  EXPECT_NEAR(values[0] / -pressure, 1, 1e-3);
  EXPECT_NEAR(values[1] / -pressure, 1, 1e-3);
  EXPECT_NEAR(values[2] / pressure, 0, 1e-9);
  EXPECT_NEAR(values[3], 2 * kSpacing + 0.5 * 14 * kSpacing, 1e-9);
  EXPECT_NEAR(values[4], 2, 1e-12);
  EXPECT_NEAR(values[5], -3, 1e-12);
  EXPECT_NEAR(values[6], 0.75, 1e-12);
  EXPECT_NEAR(values[7], 4, 1e-12);
  EXPECT_NEAR(values[8], 1 - std::numbers::pi / 4 / (kSpacing * kSpacing), 2e-3);
  EXPECT_NEAR(values[9] / (-kSide * kStiffness * 0.005), 1, 1e-9);
  EXPECT_NEAR(values[10], 0, 1e-3);
}

// The branches of all discs and the wall balance: what the wall bears goes through every column.
TEST(Branches, CarryTheWallsForce) {
  GeneralEngine engine(pressed_square(), 1);
  engine.step_interface({1, 1e-9});
  double at_wall = 0;
  for (const Branch& b : branches_of(engine))
    if (b.x_2 < -0.4) {
      EXPECT_NEAR(b.x_2, -0.495, 1e-9);
      EXPECT_NEAR(b.y_2, b.y_1, 1e-9);
      at_wall += b.fx;
    }
  EXPECT_NEAR(at_wall, -engine.walls()[0].x, 1e-3);
  EXPECT_GT(at_wall, 0);
}

// Every disc inside is pressed by four contacts of kn 0.01 m at arms of half the spacing, over its own area.
TEST(Branches, StressOfParticlesIsThatOfAnEvenState) {
  GeneralEngine engine(pressed_square(), 1);
  engine.step_interface({1, 1e-9});
  const Particles& p = engine.particles();
  const auto stress = particle_stress(engine);
  const double expected = -2 * kStiffness * 0.01 * kSpacing / 2 / (std::numbers::pi / 4);
  std::size_t inside = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double last = (kSide - 1.5) * kSpacing;
    if (p.x[i] > last || p.y[i] > last || p.y[i] < 0.5) continue;
    ++inside;
    const double by_wall = p.x[i] < 0.5 ? 0.75 : 1;  // which overlaps half as much as a disc
    EXPECT_NEAR(stress[i].xx / expected, by_wall, 1e-6);
    EXPECT_NEAR(stress[i].yy / expected, 1, 1e-6);
    EXPECT_NEAR(stress[i].xy / expected, 0, 1e-6);
  }
  EXPECT_EQ(inside, std::size_t{kSide - 1} * (kSide - 2));
}

// Whole bonds hold; contacts touch without holding; what has broken and come apart does neither.
TEST(Branches, BondsHoldAndContactsTouch) {
  Model model = test::loose_discs({{0, 0, 0.5}, {1, 0, 0.5}, {1.99, 0, 0.5}, {3.2, 0, 0.5}}, kContact);
  model.overlaps_free = false;
  model.contact_bonds = {{kStiffness, kStiffness, 1e3, 1e3}};
  model.bonds = {{0, 1, Bond::Law::kContactBond, 0}};
  GeneralEngine engine(model, 1);
  engine.step_interface({1, 1e-6});
  EXPECT_EQ(whole_bonds(engine), (std::vector<Pair>{{0, 1}}));
  EXPECT_EQ(touching_particles(engine), (std::vector<Pair>{{0, 1}, {1, 2}}));
  EXPECT_EQ(fragments_of(4, whole_bonds(engine)).number, (std::vector<std::uint32_t>{0, 0, 1, 2}));
  engine.particles().vx[0] = -1e3;
  engine.step_interface({2, 1e-6});
  EXPECT_TRUE(whole_bonds(engine).empty());
  EXPECT_EQ(touching_particles(engine), (std::vector<Pair>{{1, 2}}));
}

using Case = adit::test::Refusal<std::function<void(scene::Particles&)>>;
class HistoryErrors : public testing::TestWithParam<Case> {};

TEST_P(HistoryErrors, NameTheFieldAndTheRemedy) {
  const GeneralEngine engine(pressed_square(), 1);
  scene::Particles scene;
  add(scene, scene::DISPLACEMENT_X, 0);
  GetParam().input(scene);
  adit::test::expect_refusal([&] { Histories(scene, engine, {}); },
                             "particles.histories[1]." + GetParam().path, GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    All, HistoryErrors,
    testing::Values(Case{"NoRadius", "radius", "is missing; stress_xx of particles is a mean over a circle",
                         [](auto& s) { add(s, scene::STRESS_XX, 0); }},
                    Case{"NoMiddle", "at", "is missing; give the circle's middle",
                         [](auto& s) { add(s, scene::POROSITY, 3).clear_at(); }},
                    Case{"EmptyCircle", "radius",
                         "is 0.4 m, but the centres of 0 particle(s) lie so near to (14.3, 13.8) m",
                         [](auto& s) { add(s, scene::COORDINATION, 0.4); }},
                    Case{"NoWall", "wall", "is missing, but force_x is a force on a wall; choose one of wall",
                         [](auto& s) { s.add_histories()->set_quantity(scene::FORCE_X); }},
                    Case{"UnknownWall", "wall", "choose one of wall",
                         [](auto& s) {
                           add_force(s, scene::FORCE_Y);
                           s.mutable_histories(1)->set_wall("ceiling");
                         }},
                    Case{"NoSection", "section",
                         "is missing, but moment is a force in a section; add it to particles.sections",
                         [](auto& s) { add(s, scene::MOMENT, 3); }},
                    Case{"StrainOfParticles", "quantity",
                         "is strain_xx, which particles do not have; choose a motion",
                         [](auto& s) { add(s, scene::STRAIN_XX, 3); }}),
    adit::test::kRefusalName);

}  // namespace
}  // namespace adit::dem::histories_test

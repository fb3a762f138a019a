// Springs, walls, edges, damping and lists of neighbours, each by what it must do.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/unit/dem_server/discs_models.hpp"
#include "tests/unit/dem_server/engines/general/breaking_spring.hpp"

namespace adit::dem::parts_test {
namespace {

// A bolt pulls by its pretension and stiffness, never pushes, and is gone above its strength; its energy is
// accounted.
TEST(DiscsParts, SpringsPullOnlyAndBreak) {
  Model model = test::loose_discs({{0, 0, 0.1}, {1, 0, 0.1}}, {0, 0, 0});
  model.springs = {{0, 1, 1e6, true, 500, 2e3}};
  for (const auto& [stretch, force] :
       {std::pair{1e-3, 1500.0}, {-4e-4, 100.0}, {-1e-3, 0.0}, {1.6e-3, 0.0}}) {
    Solver solver(model, 1);
    PrescribedMotions none;
    solver.particles().vx[1] = stretch;
    solver.step({1, 1.0}, test::no_loads, none);
    EXPECT_NEAR(solver.particles().fx[0], force, 1e-6);
    EXPECT_NEAR(solver.particles().fx[1], -force, 1e-6);
    EXPECT_EQ(solver.springs().broken().size(), stretch == 1.6e-3 ? 1u : 0u);
  }
  test::Run run(model, 0.002 * critical_step(model));
  test::expect_energy_while_the_spring_breaks(run);
  EXPECT_NEAR(run.solver.ledger().released, 2e3 * 2e3 / 2e6, 0.02 * 2) << "what it held at its strength";
}

// A quiet edge takes a whole wave out of a row of discs: dashpots sqrt(k m) end it as if it went on.
TEST(DiscsParts, EdgesSwallowAWave) {
  constexpr int kDiscs = 200;
  constexpr double kStiffness = 1e8, kRadius = 0.1;
  std::vector<std::array<double, 3>> places;
  for (int i = 0; i < kDiscs; ++i) places.push_back({2 * kRadius * i, 0, kRadius});
  Model model = test::loose_discs(places, {0, 0, 0});
  model.contact_bonds = {{kStiffness, 0}};
  test::join(model, Bond::Law::kContactBond);
  const double mass = model.mass[0], c = std::sqrt(kStiffness * mass);
  model.edges = {{kDiscs - 1, c, 0}};
  model.mass[kDiscs - 1] /= 2;  // half a cell
  test::Run run(model, 0.2 * std::sqrt(mass / kStiffness));
  Particles& p = run.solver.particles();
  // Goes to the right: v = -c du/dx of a smooth pulse.
  const double speed = 2 * kRadius * std::sqrt(kStiffness / mass), width = 30 * 2 * kRadius;
  for (int i = 0; i < kDiscs; ++i) {
    const double s = (p.x[i] - 100 * 2 * kRadius) / width;
    p.ux[i] = 1e-4 * std::exp(-s * s);
  }
  run.solver.start_over();
  run.solver.step({0, run.dt}, test::no_loads, run.motions);  // finds the forces of the start
  for (int i = 0; i < kDiscs; ++i) {
    const double before = (p.x[i] - speed * run.dt / 2 - 100 * 2 * kRadius) / width;
    p.vx[i] = speed * 1e-4 * 2 * before / width * std::exp(-before * before);
  }
  const auto energy = [&run] { return run.kinetic() + run.solver.strain_energy().sum(); };
  run.step();
  const double start = energy();
  while (static_cast<double>(run.next) * run.dt * speed < 220 * 2 * kRadius) run.step();
  EXPECT_LT(energy(), 1e-4 * start);
  EXPECT_NEAR(run.solver.ledger().damping.edges, start, 1e-3 * start);
  EXPECT_NEAR(energy() + run.solver.ledger().damping.edges +
                  run.solver.time_step_share(run.solver.strain_energy().sum()),
              start, 1e-9 * start);
}

// Viscous damping by the mass: a free disc slows as the scheme solves v' = -rate v, and stays stable at any
// rate.
TEST(DiscsParts, ViscousDampingSlowsByTheMass) {
  for (const double rate : {3.0, 1e9}) {
    Model model = test::loose_discs({{0, 0, 0.1}}, {1e8, 0, 0});
    model.viscous_damping = rate;
    test::Run run(model, 1e-3);
    Particles& p = run.solver.particles();
    p.vx[0] = 2;
    p.spin[0] = -1;
    run.steps(100);
    const double factor = std::pow((1 - rate * run.dt / 2) / (1 + rate * run.dt / 2), 100);
    EXPECT_NEAR(p.vx[0], 2 * factor, 1e-12);
    EXPECT_NEAR(p.spin[0], -factor, 1e-12);
    if (rate < 10) {
      EXPECT_NEAR(factor, std::exp(-0.3), 1e-6);
    }
  }
}

// Local damping resists with its share of the resultant: a falling disc gains (1 - share) g.
TEST(DiscsParts, LocalDampingSharesTheResultant) {
  Model model = test::loose_discs({{0, 0, 0.1}}, {1e8, 0, 0});
  model.local_damping = 0.3;
  test::add_gravity(model, -10);
  Solver solver(model, 1);
  Loads gravity(model, solver.particles());
  PrescribedMotions none;
  solver.particles().vy[0] = -1e-9;
  for (std::uint64_t n = 1; n <= 100; ++n) solver.step({n, 1e-3}, gravity, none);
  EXPECT_NEAR(solver.particles().vy[0], -0.7, 1e-8);
  const double work = gravity.work().accelerations;
  EXPECT_NEAR(solver.ledger().damping.local, 0.3 * work, 1e-9 * work);
}

// A disc bounces off the face of a wall and off its end, along the line to the nearest point.
TEST(DiscsParts, WallsHaveEnds) {
  Model model = test::loose_discs({{0, 0, 0.1}}, {0, 0, 0});
  const LinearContact contact{1e8, 0, 0};
  model.walls = {test::wall(0.15, 0.05, 0.15, 1, contact)};
  for (const auto& [y, turned] : {std::pair{0.5, true}, {-0.2, false}}) {
    model.discs.y = {y};
    test::Run run(model, 1e-5);
    run.solver.particles().vx[0] = 1;
    run.steps(40000);
    EXPECT_EQ(run.solver.particles().vx[0] < 0, turned) << y;
    EXPECT_EQ(run.solver.particles().vy[0], 0);
  }
  model.discs.y = {0.0};
  test::Run run(model, 2e-5);
  Particles& p = run.solver.particles();
  const double speed = 0.05;
  p.vx[0] = speed;
  run.steps(100000);
  // Reflected on the normal from the centre to the end (0.15, 0.05): 0.05 above the centre, 0.1 away.
  const double sine = 0.5, cosine = std::sqrt(1 - sine * sine);
  EXPECT_NEAR(p.vx[0] / speed, 1 - 2 * cosine * cosine, 2e-3);
  EXPECT_NEAR(p.vy[0] / speed, -2 * cosine * sine, 2e-3);
}

// A wall that presses on a disc between it and another does work, which the contacts store.
TEST(DiscsParts, WallsDoWork) {
  Model model = test::loose_discs({{0, 0, 0.1}}, {0, 0, 0});
  const LinearContact contact{1e8, 0, 0};
  model.walls = {test::wall(-1, -0.1, 1, -0.1, contact), test::wall(-1, 0.1, 1, 0.1, contact, 0, -1e-3)};
  test::Run run(model, 0.02 * critical_step(model));
  while (static_cast<double>(run.next) * run.dt < 0.5) run.step();
  const double force = run.solver.walls().force(1).y;
  EXPECT_NEAR(force, 0.5e8 * 5e-4, 0.02 * force);
  EXPECT_NEAR(run.solver.walls().work(), force * force / 1e8, 0.05 * force * force / 1e8);
  EXPECT_NEAR(run.kinetic() + run.solver.strain_energy().sum() +
                  run.solver.time_step_share(run.solver.strain_energy().sum()),
              run.solver.walls().work(), 1e-9 * run.solver.walls().work());
}

// Two discs that roll and slide keep the shear force of their contact when the list of neighbours is made
// anew.
TEST(DiscsParts, SpringsSurviveANewList) {
  const LinearContact contact{1e8, 1e8, 1e9};
  double undisturbed = 0;
  for (const bool disturbed : {false, true}) {
    Model model = test::loose_discs({{0, 0, 0.1}, {0.199, 0, 0.1}, {9, 9, 0.1}}, contact);
    model.overlaps_free = false;
    test::Run run(model, 1e-5);
    Particles& p = run.solver.particles();
    p.vy[1] = 0.1;
    if (disturbed) p.vx[2] = 2000;
    run.steps(50);
    const double moment = p.moment[0];
    if (!disturbed) {
      undisturbed = moment;
    } else {
      EXPECT_GT(run.solver.neighbours().lists(), 15u);
      EXPECT_EQ(moment, undisturbed);
      EXPECT_NE(moment, 0);
    }
  }
}

}  // namespace
}  // namespace adit::dem::parts_test

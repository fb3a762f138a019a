// Every energy of the discs is accounted for, at every step, whatever breaks, slides, turns and is damped.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/unit/dem_server/discs_models.hpp"
#include "tests/unit/dem_server/in_process_run.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::ledger_test {
namespace {

// A block of parallel-bonded discs of random size between two platens, the upper one pressing.
scene::Scene crushing() {
  scene::Scene scene;
  auto& material = *scene.mutable_material();
  material.set_young_modulus(30e9);
  material.set_poisson_ratio(0.2);
  material.set_density(2500);
  scene.mutable_time()->set_duration(1e-3);
  auto& particles = *scene.mutable_particles();
  auto& box = *particles.mutable_random_packing();
  test::set_box(box, 0.05, 0.08);
  box.set_radius_min(1.5e-3);
  box.set_radius_max(2.5e-3);
  box.set_stress(1e6);
  auto& parallel = *particles.mutable_bonds()->mutable_parallel();
  parallel.set_normal_stiffness(1e13);
  parallel.set_shear_stiffness(4e12);
  parallel.set_tensile_strength(4e6);
  parallel.set_cohesion(15e6);
  parallel.set_friction_angle(0.5);
  auto& contacts = *particles.mutable_contacts();
  contacts.set_normal_stiffness(2e10);
  contacts.set_shear_stiffness(1e10);
  contacts.set_friction(0.5);
  for (const double y : {0.0, 0.08}) {
    auto& wall = *particles.add_walls();
    wall.set_name(y > 0 ? "upper" : "lower");
    test::set(*wall.mutable_from(), -0.1, y);
    test::set(*wall.mutable_to(), 0.15, y);
    if (y > 0) wall.mutable_velocity()->set_y(-1);
  }
  return scene;
}

struct Account {
  double worst = 0, work = 0, time_step = 0;
  std::size_t cracks = 0;
  std::map<std::string, double> shares;
};

Account crush(const scene::Scene& scene, double dt_factor, double duration) {
  test::InProcessRun run(scene, {}, dt_factor);
  Account account;
  double start = 0;
  while (static_cast<double>(run.next) * run.dt < duration) {
    run.advance();
    if (run.next == 1) start = run.sum();
    account.shares = run.shares();
    account.worst = std::max(account.worst, std::abs(run.sum() + account.shares["time_step"] - start));
    account.cracks += static_cast<std::size_t>(run.predicted.cracks_size());
  }
  account.work = run.predicted.energies().external_work();
  account.time_step = account.shares["time_step"];
  return account;
}

// kinetic + strain + released + dissipated - work changes by nothing but what the pairs' own books say the
// time step took, to 1e-8 of the work, every step of a crushing included, with all laws and dampings at once;
// and that is small.
TEST(DiscsLedger, ClosesAtEveryStepOfACrushing) {
  scene::Scene scene = crushing();
  auto& particles = *scene.mutable_particles();
  particles.mutable_contacts()->set_normal_damping(0.1);
  particles.mutable_contacts()->set_shear_damping(0.1);
  particles.mutable_damping()->set_local(0.1);
  particles.mutable_damping()->set_viscous(10);
  particles.add_body_loads()->mutable_acceleration()->set_y(-10);
  const Account account = crush(scene, 0.5, 6e-4);
  EXPECT_GT(account.cracks, 50u);
  EXPECT_GT(account.work, 0);
  EXPECT_LT(account.worst, 1e-8 * account.work);
  EXPECT_LT(std::abs(account.time_step), 1e-3 * account.work);
  for (const char* name : {"friction", "contact_dashpots", "local_damping", "viscous_damping"})
    EXPECT_GT(account.shares.at(name), 0) << name;
}

// A packing without bonds that four walls squeeze until all its contacts bear.
scene::Scene squeezed(double damping) {
  scene::Scene scene = crushing();
  auto& particles = *scene.mutable_particles();
  particles.clear_random_packing();
  auto& packing = *particles.mutable_packing();
  test::set_box(packing, 0.05, 0.08);
  packing.set_radius(2e-3);
  particles.clear_bonds();
  particles.mutable_contacts()->set_normal_damping(damping);
  particles.mutable_contacts()->set_shear_damping(damping);
  constexpr double kSpeed = 0.5;
  particles.mutable_walls(0)->mutable_velocity()->set_y(kSpeed);
  particles.mutable_walls(1)->mutable_velocity()->set_y(-kSpeed);
  for (const double x : {0.0, 0.05}) {
    auto& wall = *particles.add_walls();
    wall.set_name(x > 0 ? "right" : "left");
    test::set(*wall.mutable_from(), x, -0.1);
    test::set(*wall.mutable_to(), x, 0.2);
    wall.mutable_velocity()->set_x(x > 0 ? -kSpeed : kSpeed);
  }
  return scene;
}

// Of the work, what the time step takes while the packing is squeezed; below 0 what it makes of nothing.
double share_of_time_step(double damping, double dt_factor) {
  test::InProcessRun run(squeezed(damping), {}, dt_factor);
  while (static_cast<double>(run.next) * run.dt < 6e-3) run.advance();  // 12 and 7.5 % of its sides
  return run.shares()["time_step"] / run.predicted.energies().external_work();
}

// Requirement: the critical step holds for the dashpots that appear where discs meet. The time step costs
// nothing at 0.95 of it, whatever the damping; at the step that the springs alone allow, dashpots of half the
// critical damping make energy of nothing.
TEST(DiscsLedger, StaysClosedNearTheCriticalStepWhereAllContactsBear) {
  for (const double damping : {0.0, 0.2, 0.5})
    EXPECT_LT(std::abs(share_of_time_step(damping, 0.95)), 1e-4) << damping;
  const double of_springs = test::InProcessRun(squeezed(0), {}, 1).dt,
               of_dashpots = test::InProcessRun(squeezed(0.5), {}, 1).dt;
  EXPECT_LT(of_dashpots, 0.5 * of_springs);
  EXPECT_LT(share_of_time_step(0.5, of_springs / of_dashpots), -0.1);
}

// The same where bonds break.
TEST(DiscsLedger, StaysClosedNearTheCriticalStepWhereBondsBreak) {
  scene::Scene scene = crushing();
  for (const double damping : {0.2, 0.5}) {
    scene.mutable_particles()->mutable_contacts()->set_normal_damping(damping);
    scene.mutable_particles()->mutable_contacts()->set_shear_damping(damping);
    const Account account = crush(scene, 0.95, 6e-4);
    EXPECT_GT(account.cracks, 50u);
    EXPECT_LT(std::abs(account.time_step), 1e-2 * account.work) << damping;
  }
}

// Nothing but springs that turn, stretch, slip and bend: what the time step costs falls by four as dt halves.
TEST(DiscsLedger, TheTimeStepsShareIsOfSecondOrder) {
  Model model = test::loose_discs({{0, 0, 0.1}, {0.2, 0, 0.1}, {0.35, 0, 0.05}, {0.45, 0, 0.05}}, {0, 0, 0});
  model.parallel_bonds = {{1e9, 4e8, 0.05, INFINITY, INFINITY, 0}};
  test::join(model, Bond::Law::kParallelBond);
  std::vector<double> worst;
  for (const double dt_factor : {0.2, 0.1, 0.05}) {
    test::Run run(model, dt_factor * critical_step(model));
    Particles& p = run.solver.particles();
    p.vx = {0, 0.1, 0, -0.2};
    p.vy = {-20, 0, 15, 25};
    p.spin = {100, 99, 101, 100};
    double largest = 0, peak = 0;
    while (static_cast<double>(run.next) * run.dt < 0.05) {
      run.step();
      largest = std::max(largest, std::abs(run.solver.time_step_share(run.solver.strain_energy().sum())));
      peak = std::max(peak, run.solver.strain_energy().sum());
    }
    worst.push_back(largest / peak);
  }
  EXPECT_LT(worst[1], 0.3 * worst[0]);
  EXPECT_LT(worst[2], 0.3 * worst[1]);
  EXPECT_LT(worst[2], 1e-3);
}

}  // namespace
}  // namespace adit::dem::ledger_test

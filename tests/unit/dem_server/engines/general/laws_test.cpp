// The solver's kernel computes the laws of laws/ to the last digits, pair by pair.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "dem_server/laws/smooth_joint.hpp"
#include "tests/unit/dem_server/discs_models.hpp"
#include "tests/unit/dem_server/two_bodies.hpp"

namespace adit::dem::laws_test {
namespace {

using test::Body;
using test::BondedPair;
using test::forces;
using test::meet;

Body body_of(const Solver& solver, std::size_t i) {
  const Particles& p = solver.particles();
  return {p.x[i] + p.ux[i], p.y[i] + p.uy[i], p.vx[i],           p.vy[i],
          p.spin[i],        p.radius[i],      p.inverse_mass[i], p.inverse_inertia[i]};
}

// Resultants that the forces of a pair give to two bodies.
void expect_forces(const Solver& solver, const PairForces& f, const PairKinematics& e) {
  const double fx = f.normal * e.nx - f.shear * e.ny, fy = f.normal * e.ny + f.shear * e.nx;
  const double scale = std::hypot(f.normal, f.shear);
  const Particles& p = solver.particles();
  EXPECT_NEAR(p.fx[0], fx, 1e-12 * scale);
  EXPECT_NEAR(p.fy[0], fy, 1e-12 * scale);
  EXPECT_NEAR(p.fx[1], -fx, 1e-12 * scale);
  EXPECT_NEAR(p.fy[1], -fy, 1e-12 * scale);
  const double turning = scale * e.length + std::abs(f.moment);
  EXPECT_NEAR(p.moment[0], f.shear * e.arm_1 + f.moment, 1e-12 * turning);
  EXPECT_NEAR(p.moment[1], f.shear * e.arm_2 - f.moment, 1e-12 * turning);
}

struct Two {
  Model model;
  std::mt19937 random;

  explicit Two(const LinearContact& contact, double gap)
      : model(test::loose_discs(
            {{0.3, -0.2, 0.1}, {0.3 + (0.17 + gap) * 0.6, -0.2 + (0.17 + gap) * 0.8, 0.07}}, contact)) {}
  double any(double scale) { return std::uniform_real_distribution(-scale, scale)(random); }
  void set_off(Solver& solver, double speed) {
    Particles& p = solver.particles();
    for (auto* velocity : {&p.vx, &p.vy})
      for (double& v : *velocity) v = any(speed);
    for (double& spin : p.spin) spin = any(speed / 0.1);
  }
};

// Contacts that stick, slide, damp and part.
TEST(DiscsLaws, ContactsAreLinearContacts) {
  const LinearContact law{2e6, 1e6, 0.3, 0.1, 0.05};
  Two two(law, -0.005);
  two.model.overlaps_free = false;
  const double dt = 1e-5;
  for (int trial = 0; trial < 20; ++trial) {
    Solver solver(two.model, 1);
    PrescribedMotions none;
    double shear = 0;
    for (std::uint64_t n = 1; n <= 5; ++n) {
      two.set_off(solver, trial < 15 ? 3 : 200);
      std::vector<Body> before = {body_of(solver, 0), body_of(solver, 1)};
      for (Body& body : before) {
        body.x += dt * body.vx;
        body.y += dt * body.vy;
      }
      const PairKinematics e = meet(before[0], before[1], dt);
      const PairForces f = forces(law, e, before[0], before[1], dt, shear);
      solver.step({n, dt}, test::no_loads, none);
      expect_forces(solver, f, e);
    }
  }
}

// Parallel bonds beside their contacts, until they break; then the contacts alone.
TEST(DiscsLaws, ParallelBondsActBesideContacts) {
  const LinearContact contact{2e6, 1e6, 0.3};
  const ParallelBond bond{2e7, 1e7, 0.05, 2.5e4, 2e4, 0.5};
  Two two(contact, 0);
  two.model.parallel_bonds = {bond};
  two.model.bonds = {{0, 1, Bond::Law::kParallelBond, 0}};
  const double dt = 1e-5;
  int broken = 0;
  for (int trial = 0; trial < 40; ++trial) {
    Solver solver(two.model, 1);
    PrescribedMotions none;
    BondedPair bonded{std::hypot(two.model.discs.x[1] - 0.3, two.model.discs.y[1] + 0.2)};
    double surfaces = 0;
    for (std::uint64_t n = 1; n <= 5; ++n) {
      two.set_off(solver, 60);
      std::vector<Body> before = {body_of(solver, 0), body_of(solver, 1)};
      for (Body& body : before) {
        body.x += dt * body.vx;
        body.y += dt * body.vy;
      }
      const PairKinematics e = meet(before[0], before[1], dt);
      const PairForces a = forces(bond, e, dt, bonded),
                       b = forces(contact, e, before[0], before[1], dt, surfaces);
      solver.step({n, dt}, test::no_loads, none);
      // The elongation of bodies loses digits of their places that the solver keeps.
      const double lost = 1e-15 * bond.normal_stiffness * bond.area();
      const Particles& p = solver.particles();
      const double normal = a.normal + b.normal, shear = a.shear + b.shear;
      const double scale = 1e-12 * std::hypot(normal, shear) + lost;
      EXPECT_NEAR(p.fx[0], normal * e.nx - shear * e.ny, scale);
      EXPECT_NEAR(p.fy[0], normal * e.ny + shear * e.nx, scale);
      EXPECT_NEAR(p.moment[0], shear * e.arm_1 + a.moment, scale);
      EXPECT_NEAR(p.moment[1], shear * e.arm_2 - a.moment, scale);
      EXPECT_EQ(solver.bonds().state[0], bonded.state);
    }
    broken += bonded.state != BondState::kIntact;
  }
  EXPECT_GT(broken, 5);
  EXPECT_LT(broken, 35);
}

// A contact bond pulls, sticks, and leaves a contact with friction where it breaks.
TEST(DiscsLaws, ContactBondsLeaveContacts) {
  Two two({2e6, 1e6, 0.3}, 0);
  two.model.contact_bonds = {{2e6, 1e6, 1e3, 2e3}};
  two.model.bonds = {{0, 1, Bond::Law::kContactBond, 0}};
  const double nx = 0.6, ny = 0.8, dt = 1e-5;
  const auto pulled_by = [&](double stretch, double slip) {
    Solver solver(two.model, 1);
    Particles& p = solver.particles();
    p.vx[1] = (stretch * nx - slip * ny) / dt;
    p.vy[1] = (stretch * ny + slip * nx) / dt;
    PrescribedMotions none;
    solver.step({1, dt}, test::no_loads, none);
    return std::tuple(p.fx[0] * nx + p.fy[0] * ny, p.fy[0] * nx - p.fx[0] * ny, solver.bonds().state[0]);
  };
  const auto [pull_n, pull_t, whole] = pulled_by(4.9e-4, 0);
  EXPECT_NEAR(pull_n, 980, 1e-6);
  EXPECT_EQ(whole, BondState::kIntact);
  const auto [gone_n, gone_t, torn] = pulled_by(5.1e-4, 0);
  EXPECT_EQ(gone_n, 0);
  EXPECT_EQ(torn, BondState::kTensileCrack);
  const auto [press_n, press_t, sheared] = pulled_by(-1e-3, 2.1e-3);
  EXPECT_EQ(sheared, BondState::kShearCrack);
  EXPECT_NEAR(press_n, -2e6 * (0.17 - std::hypot(0.169, 2.1e-3)), 1) << "what was compressed stays so";
}

// A smooth joint slides along its plane, whatever the direction of the pair, and keeps momenta and energy.
TEST(DiscsLaws, SmoothJointsSlideAlongTheirPlane) {
  const SmoothJoint joint{1e9, 4e8, 0.2, 0.0, 0.1};
  Two two({1e8, 1e8, 0.5}, 0);
  two.model.smooth_joints = {joint};
  two.model.bonds = {{0, 1, Bond::Law::kSmoothJoint, 0, 0, 1}};
  test::Run run(two.model, 0.05 * critical_step(two.model));
  Particles& p = run.solver.particles();
  p.vy = {1, -1};
  p.vx = {0, 2};
  p.spin = {3, -1};
  double friction = 0, largest = 0, total = 0;
  for (int n = 0; n < 2000; ++n) {
    run.step();
    const DiscLedger ledger = run.solver.ledger();
    friction = ledger.friction;
    largest = std::max(largest, std::abs(run.solver.joints().joints()[0].normal));
    const double sum = run.kinetic() + run.solver.strain_energy().sum() + friction +
                       run.solver.time_step_share(run.solver.strain_energy().sum());
    if (n == 0) total = sum;
    ASSERT_NEAR(sum, total, 1e-9 * total);
  }
  EXPECT_GT(friction, 0.01 * total);
  EXPECT_GT(largest, 0);
  EXPECT_LT(std::abs(run.solver.time_step_share(run.solver.strain_energy().sum())), 1e-3 * total);
}

}  // namespace
}  // namespace adit::dem::laws_test

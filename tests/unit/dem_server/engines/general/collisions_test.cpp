// Two bodies collide as closed forms say: the tests of Chung & Ooi 2011 (Granular Matter 13, 643) through the
// whole solver.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/unit/dem_server/discs_models.hpp"

namespace adit::dem::collisions_test {
namespace {

constexpr double kStiffness = 1e9, kRadius = 0.1, kSpeed = 1e-5;
const double kMass = test::kSolidDensity * std::numbers::pi * kRadius * kRadius;

double contact_time(double mass) {
  return std::numbers::pi * std::sqrt(mass / kStiffness);
}

// Two equal discs that touch and come towards each other at 2 kSpeed, or one that comes towards a wall at
// kSpeed.
Model before_impact(bool with_wall, const LinearContact& law) {
  if (!with_wall) return test::loose_discs({{0, 0, kRadius}, {2 * kRadius, 0, kRadius}}, law);
  Model model = test::loose_discs({{0, 0, kRadius}}, law);
  model.walls = {test::wall(kRadius, -1, kRadius, 1, law)};
  return model;
}

// Requirement: a disc whose centre lies on a wall, from which no direction leads to the wall, meets it along
// the wall's normal: what it does then is a number.
TEST(Collision, ACentreOnAWallMeetsItsNormal) {
  Model model = test::loose_discs({{kRadius, 0, kRadius}}, {kStiffness, kStiffness, 0.5});
  model.walls = {test::wall(kRadius, -1, kRadius, 1, {kStiffness, kStiffness, 0.5})};
  test::Run run(model, 1e-6);
  Particles& p = run.solver.particles();
  p.vx[0] = p.vy[0] = kSpeed;
  for (int n = 0; n < 3; ++n) run.step();
  EXPECT_TRUE(std::isfinite(p.vx[0]) && std::isfinite(p.vy[0]) && std::isfinite(p.spin[0]));
}

struct Collision {
  double duration, overlap;
  double vx, vy, spin;  // of the first disc afterwards
};

Collision collide(bool with_wall, const LinearContact& law, double dt, double vy = 0, double spin = 0,
                  double first_kick = 0) {
  test::Run run(before_impact(with_wall, law), dt);
  Particles& p = run.solver.particles();
  p.vx[0] = kSpeed - first_kick;
  p.vy[0] = vy;
  p.spin[0] = spin;
  if (!with_wall) p.vx[1] = -p.vx[0];
  Collision out{};
  const auto gap_now = [&] { return with_wall ? -p.ux[0] : p.ux[1] - p.ux[0]; };
  for (double before = 0;;) {
    run.step();
    const double gap = gap_now();
    if (gap >= 0) {
      out.duration = (static_cast<double>(run.next - 1) - gap / (gap - before)) * dt;
      break;
    }
    out.overlap = std::max(out.overlap, -gap);
    before = gap;
  }
  out.vx = p.vx[0];
  out.vy = p.vy[0];
  out.spin = p.spin[0];
  return out;
}

// Duration pi sqrt(m*/k), overlap v sqrt(m*/k), velocities turned round, to 1e-6 at 4000 steps; the error of
// the duration falls by four as dt halves.
TEST(Collisions, ElasticNormalImpact) {
  const LinearContact law{kStiffness, 0, 0};
  for (const bool with_wall : {false, true}) {
    const double mass = with_wall ? kMass : kMass / 2, closing = with_wall ? kSpeed : 2 * kSpeed;
    std::vector<double> error;
    for (const double steps : {100.5, 201.0, 4000.3}) {
      const Collision c = collide(with_wall, law, contact_time(mass) / steps);
      error.push_back(std::abs(c.duration / contact_time(mass) - 1));
      EXPECT_EQ(c.vy, 0);
      EXPECT_EQ(c.spin, 0);
      if (steps < 4000) continue;
      EXPECT_NEAR(c.overlap, closing * std::sqrt(mass / kStiffness), 1e-6 * c.overlap);
      EXPECT_NEAR(c.vx, -kSpeed, 1e-6 * kSpeed);
    }
    EXPECT_LT(error[1], 0.3 * error[0]);
    EXPECT_LT(error[2], 1e-6);
  }
}

// Restitution of a spring and a dashpot that never pull (Schwager & Poschel 2007, Granular Matter 9, 465), to
// 1e-6 and of second order in dt. The dashpot pushes from the first instant: half of a kick before the first
// move.
TEST(Collisions, DashpotsGiveTheRestitution) {
  for (const bool with_wall : {false, true})
    for (const double beta : {0.05, 0.3, 0.6}) {
      const double mass = with_wall ? kMass : kMass / 2, closing = with_wall ? kSpeed : 2 * kSpeed;
      const double root = std::sqrt(1 - beta * beta);
      const double expected = std::exp(-beta / root * std::atan2(2 * beta * root, 2 * beta * beta - 1));
      double error[2];
      for (const int fine : {0, 1}) {
        const double dt = contact_time(mass) / (fine ? 4000 : 500);
        const double kick = 2 * beta * std::sqrt(mass * kStiffness) * closing * dt / 2 / kMass;
        const Collision c = collide(with_wall, {kStiffness, 0, 0, beta}, dt, 0, 0, kick);
        error[fine] = std::abs(-c.vx / kSpeed / expected - 1);
      }
      EXPECT_LT(error[1], 1e-6) << beta;
      EXPECT_LT(error[1], 0.04 * error[0]) << beta;
    }
}

// An oblique impact that slides to its end: the tangential impulse is mu times the normal one and spins the
// disc.
TEST(Collisions, GrossSlidingKeepsCoulombsRatio) {
  const double mu = 0.2;
  for (const bool with_wall : {false, true}) {
    const double vy = 4 * kSpeed;
    const Collision c = collide(with_wall, {kStiffness, 1e13, mu}, contact_time(kMass) / 5000, vy);
    const double across = c.vx - kSpeed, along = c.vy - vy;
    EXPECT_NEAR(along / across, mu, 1e-6);
    EXPECT_NEAR(c.spin, 2 * along / kRadius, 1e-6 * std::abs(c.spin));
  }
}

// One that sticks to its end is a spring along the wall: the velocity of the surface becomes cos(w T) times
// what it was, w^2 = ks (1/m + R^2/J), T the duration; second order in dt.
TEST(Collisions, StickingIsASpringAlongTheWall) {
  const double shear = kStiffness / 3, inertia = kMass * kRadius * kRadius / 2;
  for (const double spin : {0.0, 2e-4}) {
    std::vector<double> error;
    for (const double steps : {100.0, 200.0, 8000.0}) {
      const Collision c =
          collide(true, {kStiffness, shear, 1e9}, contact_time(kMass) / steps, 0.3 * kSpeed, spin);
      const double surface = -0.3 * kSpeed - kRadius * spin, after = -c.vy - kRadius * c.spin;
      const double w = std::sqrt(shear * (1 / kMass + kRadius * kRadius / inertia));
      error.push_back(std::abs(after / surface - std::cos(w * contact_time(kMass))));
    }
    EXPECT_LT(error[1], 0.3 * error[0]);
    EXPECT_LT(error[2], 1e-6);
  }
}

// Two discs in an oblique impact with friction, dashpots and spins keep momentum and angular momentum to
// rounding.
TEST(Collisions, KeepMomenta) {
  Model model =
      test::loose_discs({{0, 0, 0.1}, {0.19, 0.1, 0.12}}, {kStiffness, 0.3 * kStiffness, 0.3, 0.2, 0.1});
  test::Run run(model, 1e-5);
  Particles& p = run.solver.particles();
  p.vx = {1.0, -0.5};
  p.vy = {0.3, -0.4};
  p.spin = {1, -2};
  const auto momenta = [&] {
    std::array<double, 3> sum{};
    for (int i : {0, 1}) {
      sum[0] += p.mass[i] * p.vx[i];
      sum[1] += p.mass[i] * p.vy[i];
      sum[2] += p.mass[i] * ((p.x[i] + p.ux[i]) * p.vy[i] - (p.y[i] + p.uy[i]) * p.vx[i]) +
                p.inertia[i] * p.spin[i];
    }
    return sum;
  };
  const auto before = momenta();
  double strongest = 0;
  for (int n = 0; n < 3000; ++n) {
    run.step();
    strongest = std::max(strongest, run.solver.strongest().force);
  }
  EXPECT_GT(strongest, 1e5);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(momenta()[k], before[k], 1e-11 * 60) << k;
}

// A block that its weight presses on a wall slides v^2 / (2 mu g) until friction stops it.
TEST(Collisions, FrictionStopsASlidingBlock) {
  const double mu = 0.4, g = 10, speed = 0.5, pressed = kMass * g / kStiffness;
  const LinearContact contact{kStiffness, kStiffness, mu};
  Model model = test::loose_discs({{0, kRadius - pressed, kRadius}}, contact);
  model.overlaps_free = false;
  model.walls = {test::wall(-1, 0, 1, 0, contact)};
  test::add_gravity(model, -g);
  model.motions = {{Component::kSpin, {0}, 0, test::always, "motions"}};
  const double dt = 0.02 * critical_step(model);
  Solver solver(model, 1);
  Particles& p = solver.particles();
  Loads gravity(model, p);
  PrescribedMotions motions(model, p);
  p.vx[0] = speed;
  for (std::uint64_t n = 1; static_cast<double>(n) * dt < 1.5 * speed / (mu * g); ++n)
    solver.step({n, dt}, gravity, motions);
  EXPECT_NEAR(p.ux[0], speed * speed / (2 * mu * g), 1e-4 * speed * speed / (2 * mu * g));
}

}  // namespace
}  // namespace adit::dem::collisions_test

// Statics, rigid motion, energy and momentum.
#include <gtest/gtest.h>

#include "protocol/errors.hpp"
#include "tests/unit/simplified/chain/chains.hpp"

namespace adit::simplified::chain::mechanics_test {
namespace {

// Random numbers in [-1, 1] that are the same everywhere.
std::vector<double> random(std::size_t n, unsigned seed) {
  std::vector<double> values(n);
  for (double& value : values) {
    seed = 1664525 * seed + 1013904223;
    value = 2 * (seed / 4294967296.0) - 1;
  }
  return values;
}

// Where the centres are, the first body beginning at the origin.
struct Places {
  std::vector<double> x, y;
  explicit Places(const Chain& chain) {
    double at_x = 0, at_y = 0;
    for (const Body& body : chain.bodies) {
      const double dx = body.length * std::cos(body.angle), dy = body.length * std::sin(body.angle);
      x.push_back(at_x + 0.5 * dx);
      y.push_back(at_y + 0.5 * dy);
      at_x += dx;
      at_y += dy;
    }
  }
};

Chain free_winding(std::size_t n) {
  Chain chain = test::winding(n);
  chain.start.reset();
  for (Body& body : chain.bodies) body.ground_stiffness = body.ground_dashpot = {};
  return chain;
}

// A cantilever of rigid bodies under constant loads on its last: every joint force is that of statics, every
// deformation that of the joint's stiffness, and the last body is where they put it.
TEST(Statics, Cantilever) {
  const std::size_t n = 5;
  Chain chain = test::segments(n);
  chain.start = test::joint();
  std::vector<double> pull(n), push(n);
  pull[n - 1] = 3e6;
  push[n - 1] = 2e6;
  Simulation run(chain, {.dt = 10, .newmark = test::kSettling});
  for (int step = 0; step < 300; ++step) run.step({.load_x = pull, .load_y = push});
  const Joints joints = run.joints();
  double deflection = 0;
  for (std::size_t j = 0; j < n; ++j) {
    const double arm = 22.5 * (static_cast<double>(n) - 0.5 - static_cast<double>(j));
    EXPECT_NEAR(joints.axial.force[j], 3e6, 1e-3);
    EXPECT_NEAR(joints.shear.force[j], 2e6, 1e-3);
    EXPECT_NEAR(joints.rotation.force[j], 2e6 * arm, 1e-2);
    EXPECT_NEAR(joints.axial.deformation[j], 3e6 / 2e9, 1e-12);
    EXPECT_NEAR(joints.rotation.deformation[j], 2e6 * arm / 5e12, 1e-15);
    deflection += 2e6 / 5e10 + arm * arm * 2e6 / 5e12;
  }
  EXPECT_NEAR(run.bodies().y[n - 1], deflection, 1e-11);
  EXPECT_NEAR(run.bodies().x[n - 1], 5 * 3e6 / 2e9, 1e-11);
  EXPECT_EQ(joints.axial.force[n], 0) << "a free end carries nothing";
}

// Statics on the turned axes: the same cantilever in a direction of 40 degrees carries the same joint forces.
TEST(Statics, AxesTurnWithTheBodies) {
  const double angle = 40 * M_PI / 180;
  Chain chain = test::segments(3);
  chain.start = test::joint();
  for (Body& body : chain.bodies) body.angle = angle;
  const std::vector<double> x{0, 0, 3e6 * std::cos(angle) - 2e6 * std::sin(angle)},
      y{0, 0, 3e6 * std::sin(angle) + 2e6 * std::cos(angle)};
  Simulation run(chain, {.dt = 10, .newmark = test::kSettling});
  for (int step = 0; step < 300; ++step) run.step({.load_x = x, .load_y = y});
  for (std::size_t j = 0; j < 3; ++j) {
    EXPECT_NEAR(run.joints().axial.force[j], 3e6, 1e-3);
    EXPECT_NEAR(run.joints().shear.force[j], 2e6, 1e-3);
  }
}

// A chain that follows ground moving as one shows no joint forces once it has settled there.
TEST(Statics, FollowsTheGround) {
  const std::size_t n = 40;
  Chain chain = test::winding(n);
  chain.finish = test::joint();
  const std::vector<double> x(n, 0.3), y(n, -0.2);
  Simulation run(chain, {.dt = 1, .newmark = test::kSettling});
  for (int step = 0; step < 400; ++step) run.step({.ground_x = x, .ground_y = y});
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_NEAR(run.bodies().x[i], 0.3, 1e-13);
    EXPECT_NEAR(run.bodies().y[i], -0.2, 1e-13);
    EXPECT_LT(std::abs(run.joints().axial.force[i]), 1e-3);
  }
}

// A rigid rotation of the whole winding chain deforms no joint.
TEST(RigidMotion, RotationDeformsNothing) {
  const Chain chain = free_winding(50);
  const Places at(chain);
  std::vector<double> x(50), y(50), turn(50, 0.01);
  for (std::size_t i = 0; i < 50; ++i) {
    x[i] = -0.01 * at.y[i];
    y[i] = 0.01 * at.x[i];
  }
  Simulation run(chain, {.dt = 0.01});
  run.start({.x = x, .y = y, .rotation = turn});
  for (std::size_t j = 1; j < 50; ++j) {
    EXPECT_LT(std::abs(run.joints().axial.deformation[j]), 1e-13);
    EXPECT_LT(std::abs(run.joints().shear.deformation[j]), 1e-13);
  }
}

struct Sums {
  double x = 0, y = 0, angular = 0, kinetic = 0, energy = 0;
};

Sums sums(const Chain& chain, const Simulation& run) {
  const Places at(chain);
  const BodyMotion m = run.bodies();
  Sums s;
  for (std::size_t i = 0; i < chain.bodies.size(); ++i) {
    const Body& body = chain.bodies[i];
    s.x += body.mass * m.vx[i];
    s.y += body.mass * m.vy[i];
    s.angular += body.mass * (at.x[i] * m.vy[i] - at.y[i] * m.vx[i]) + body.inertia * m.spin[i];
    s.kinetic +=
        0.5 * (body.mass * (m.vx[i] * m.vx[i] + m.vy[i] * m.vy[i]) + body.inertia * m.spin[i] * m.spin[i]);
    const double c = std::cos(body.angle), sine = std::sin(body.angle), u = c * m.x[i] + sine * m.y[i],
                 w = c * m.y[i] - sine * m.x[i];
    s.energy += 0.5 * (body.ground_stiffness.axial * u * u + body.ground_stiffness.lateral * w * w +
                       body.ground_stiffness.rotation * m.rotation[i] * m.rotation[i]);
  }
  const Joints joints = run.joints();
  for (const JointDirection* d : {&joints.axial, &joints.shear, &joints.rotation})
    for (std::size_t j = 0; j < d->force.size(); ++j) s.energy += 0.5 * d->force[j] * d->deformation[j];
  s.energy += s.kinetic;
  return s;
}

// A free winding chain, kicked at random, keeps momentum and angular momentum to 1e-12, its hinges damped or
// not.
TEST(Conservation, MomentumOfAFreeChain) {
  const std::size_t n = 60;
  const Chain chain = free_winding(n);
  const auto vx = random(n, 1), vy = random(n, 2);
  Simulation run(chain, {.dt = 0.005});
  run.start({.vx = vx, .vy = vy});
  const Sums start = sums(chain, run);
  const double scale = std::sqrt(2 * start.kinetic * n * 9.5e6);
  for (int step = 0; step < 2000; ++step) run.step({});
  const Sums end = sums(chain, run);
  EXPECT_LT(std::abs(end.x - start.x), 1e-12 * scale);
  EXPECT_LT(std::abs(end.y - start.y), 1e-12 * scale);
  EXPECT_LT(std::abs(end.angular - start.angular), 1e-12 * scale * n * 22.5);
  EXPECT_LT(end.energy, 0.9 * start.energy) << "the dashpots take energy";
}

// Newmark's average acceleration keeps the energy of an undamped chain on springs to 1e-11 over 10,000 steps.
TEST(Conservation, EnergyWithoutDamping) {
  const std::size_t n = 60;
  Chain chain = test::winding(n);
  for (Body& body : chain.bodies) body.ground_dashpot = {};
  for (Hinge& hinge : chain.hinges) hinge.axial.dashpot = hinge.shear.dashpot = hinge.rotation.dashpot = 0;
  const auto vx = random(n, 3), vy = random(n, 4);
  Simulation run(chain, {.dt = 0.005});
  run.start({.vx = vx, .vy = vy});
  const double start = sums(chain, run).energy;
  double worst = 0;
  for (int step = 0; step < 10000; ++step) {
    run.step({});
    if (step % 100 == 0) worst = std::max(worst, std::abs(sums(chain, run).energy - start));
  }
  EXPECT_LT(worst, 1e-11 * start);
}

// Envelopes hold the least and greatest of what every step reported.
TEST(Envelopes, HoldTheExtremes) {
  const std::size_t n = 150;
  const Chain chain = test::winding(n);
  Simulation run(chain, {.dt = 0.01});
  test::Wave wave(n);
  std::vector<double> most(n + 1), least(n + 1);
  for (int step = 1; step <= 300; ++step) {
    run.step(wave.at(0.01 * step));
    for (std::size_t j = 0; j <= n; ++j) {
      most[j] = std::max(most[j], run.joints().rotation.force[j]);
      least[j] = std::min(least[j], run.joints().rotation.force[j]);
    }
  }
  EXPECT_EQ(run.envelopes().moment.max, most);
  EXPECT_EQ(run.envelopes().moment.min, least);
  EXPECT_GT(most[n / 2], 0);
  EXPECT_EQ(run.envelopes().x.max.size(), n);
}

// Two runs of the same chain give the same bits.
TEST(Reproducibility, SameBits) {
  std::vector<double> ends[2];
  for (auto& end : ends) {
    Simulation run(test::winding(300), {.dt = 0.01});
    test::Wave wave(300);
    for (int step = 1; step <= 100; ++step) run.step(wave.at(0.01 * step));
    end.assign(run.bodies().x.begin(), run.bodies().x.end());
  }
  EXPECT_EQ(ends[0], ends[1]);
}

// A load that is not finite stops the run with the step and the body.
TEST(Unstable, NamesStepAndBody) {
  Simulation run(test::segments(5), {.dt = 0.01});
  std::vector<double> load(5);
  run.step({.load_x = load});
  load[3] = NAN;
  try {
    run.step({.load_x = load});
    FAIL() << "accepted";
  } catch (const protocol::Unstable& error) {
    EXPECT_STREQ(error.what(), "step 2, t = 0.02 s: the force on body 3 is not finite");
  }
}

}  // namespace
}  // namespace adit::simplified::chain::mechanics_test

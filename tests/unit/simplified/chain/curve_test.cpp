// Hinges with curves: gaskets that carry compression only, and stops with clearance.
#include "simplified/chain/model/curve.hpp"

#include <gtest/gtest.h>

#include <array>
#include <utility>

#include "protocol/errors.hpp"
#include "tests/unit/simplified/chain/chains.hpp"

namespace adit::simplified::chain::curve_test {
namespace {

// Between points the force is interpolated, beyond them the outer lines go on.
TEST(Curve, IsPiecewiseLinear) {
  const Curve curve{{-2, 0, 1, 3}, {-10, -2, 0, 0}};
  const std::vector<std::array<double, 2>> points{{-3, -14}, {-2, -10}, {-1, -6}, {0, -2},
                                                  {0.5, -1}, {1, 0},    {9, 0}};
  for (const auto& [deformation, force] : points)
    EXPECT_DOUBLE_EQ(line_at(curve, deformation).at(deformation), force);
}

// A body flies against a spring that only presses, and leaves it half a period later as fast as it came.
double error_of_bounce(double dt) {
  const double k = 400, m = 1, omega = std::sqrt(k / m), gap = 0.3, speed = 1;
  Chain chain{{Body{}}, {}, Hinge{}, {}};
  chain.bodies[0].length = chain.bodies[0].mass = chain.bodies[0].inertia = 1;
  chain.start->axial.curve = {{-1, 0, 1}, {-k, 0, 0}};
  Simulation run(chain, {.dt = dt});
  run.start({.x = {&gap, 1}, .vx = std::vector<double>{-speed}});
  while (run.time() < 0.9) run.step({});
  EXPECT_LE(run.envelopes().axial_force.max[0], 0) << "it never pulls";
  EXPECT_NEAR(run.envelopes().axial_force.min[0], -k * speed / omega, 0.02 * k * speed / omega);
  EXPECT_EQ(run.joints().axial.force[0], 0);
  return std::abs(run.bodies().x[0] - speed * (run.time() - gap - M_PI / omega));
}

TEST(CompressionOnly, BodyBouncesOff) {
  EXPECT_LT(error_of_bounce(0.001), 2e-3);
  EXPECT_LT(error_of_bounce(0.0001), 2e-4);
}

// A gasket pressed by the water parts when the tension exceeds that force, and not before. Two bodies on soil
// springs are pulled apart: it parts at 30 mm, where the pull is the soil's k 15 mm and the water's 171 MN.
TEST(CompressionOnly, GasketOpensBeyondItsPrecompression) {
  Chain chain = test::segments(2);
  for (Body& body : chain.bodies) body.ground_stiffness.axial = 1e9;
  chain.hinges[0].axial = {0, 0, Curve{{-0.05, 0, 0.03, 0.04}, {-600e6, -171e6, 0, 0}}};
  const double parting = 1e9 * 0.015 + 171e6;
  const auto settled = [&](double pull) {
    Simulation run(chain, {.dt = 1, .newmark = test::kSettling});
    EXPECT_EQ(run.joints().axial.force[1], -171e6) << "at rest";
    const std::vector<double> load{-pull, pull};
    for (int step = 0; step < 400; ++step) run.step({.load_x = load});
    return std::pair(run.joints().axial.deformation[1], run.joints().axial.force[1]);
  };
  const auto [closed_opening, closed_force] = settled(0.99 * parting);
  EXPECT_LT(closed_opening, 0.03);
  EXPECT_NEAR(closed_force, -0.01 * parting * 5.7e9 / (0.5e9 + 5.7e9), 1);
  const auto [opening, force] = settled(1.01 * parting);
  EXPECT_NEAR(opening, 0.03 + 0.01 * parting / 0.5e9, 1e-9);
  EXPECT_EQ(force, 0);
}

// A chain of hardening gaskets, shear keys with clearance and softening rotation, shaken hard: in every step
// the equations of motion hold with forces that lie on the curves, to the stated tolerance.
TEST(CurvedHinges, EquationsHoldInEveryStep) {
  const std::size_t n = 30;
  Chain chain = test::winding(n);
  for (Body& body : chain.bodies) body.angle = 0;
  const Curve gasket{{-0.05, -0.01, 0, 0.002, 0.01}, {-600e6, -30e6, -10e6, 0, 0}};
  const Curve key{{-0.01, -0.002, 0.002, 0.01}, {-4e8, 0, 0, 4e8}};
  const Curve rotation{{-0.01, -0.0001, 0.0001, 0.01}, {-2e9, -1e9, 1e9, 2e9}};
  for (Hinge& hinge : chain.hinges) {
    hinge.axial = {0, 1e7, gasket};
    hinge.shear = {0, 1e7, key};
    hinge.rotation = {0, 1e9, rotation};
  }
  Simulation run(chain, {.dt = 0.01});
  test::Wave wave(n);
  double worst = 0, largest = 0;
  for (int step = 1; step <= 1000; ++step) {
    const Excitation e = wave.at(0.01 * step);
    run.step(e);
    const BodyMotion m = run.bodies();
    const Joints f = run.joints();
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const Body& body = chain.bodies[i];
      const double x = body.ground_stiffness.axial * (e.ground_x[i] - m.x[i]) +
                       body.ground_dashpot.axial * (e.ground_vx[i] - m.vx[i]) + f.axial.force[i + 1] -
                       f.axial.force[i] - body.mass * m.ax[i];
      const double y = body.ground_stiffness.lateral * (e.ground_y[i] - m.y[i]) +
                       body.ground_dashpot.lateral * (e.ground_vy[i] - m.vy[i]) + f.shear.force[i + 1] -
                       f.shear.force[i] - body.mass * m.ay[i];
      worst = std::max({worst, std::abs(x), std::abs(y)});
    }
    for (std::size_t j = 1; j < n; ++j) largest = std::max(largest, std::abs(f.axial.force[j]));
  }
  EXPECT_LT(worst, 4 * 1e-9 * 600e6);
  EXPECT_LT(*std::max_element(run.envelopes().shear_force.min.begin() + 1,
                              run.envelopes().shear_force.min.end() - 1),
            0)
      << "every key was struck";
  EXPECT_GT(run.iterations(), run.steps()) << "curves were crossed";
  EXPECT_GT(largest, 20e6);
}

// A curve that is one straight line gives the motion of the stiffness.
TEST(CurvedHinges, StraightCurveIsAStiffness) {
  Chain straight = test::winding(20), curved = straight;
  for (Hinge& hinge : curved.hinges) {
    const double k = std::exchange(hinge.axial.stiffness, 0);
    hinge.axial.curve = {{-1, 0, 1}, {-k, 0, k}};
  }
  Simulation a(straight, {.dt = 0.01}), b(curved, {.dt = 0.01});
  test::Wave wave(20);
  for (int step = 1; step <= 300; ++step) {
    const Excitation e = wave.at(0.01 * step);
    a.step(e);
    b.step(e);
    for (std::size_t i = 0; i < 20; ++i) ASSERT_NEAR(a.bodies().x[i], b.bodies().x[i], 1e-12);
  }
}

// Where the iterations do not reach a curve the run stops, and says which and what to do.
TEST(CurvedHinges, NoConvergenceIsAnError) {
  Chain chain = test::segments(3);
  chain.hinges[1].shear = {0, 0, Curve{{-1, 0, 1}, {-1e9, 0, 5e9}}};
  Simulation run(chain, {.dt = 0.1, .max_iterations = 1});
  const std::vector<double> load{0, 0, 1e8};
  try {
    for (int step = 0; step < 100; ++step)
      run.step({.load_y = step % 2 ? load : std::vector<double>{0, 0, -2e8}});
    FAIL() << "went on";
  } catch (const protocol::Unstable& error) {
    EXPECT_NE(std::string(error.what()).find("shear force of joint 2 deviates from its curve"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace adit::simplified::chain::curve_test

// The integration has its order of convergence, measured against closed forms.
#include "simplified/chain/joints/integrator.hpp"

#include <gtest/gtest.h>

#include <complex>

#include "tests/unit/simplified/chain/chains.hpp"

namespace adit::simplified::chain::integrator_test {
namespace {

struct Order {
  Newmark newmark;
  double order;
};
const std::vector<Order> kOrders{{Newmark{}, 2}, {Newmark{0.3025, 0.6}, 1}};

// The exponent with which the error falls when dt is halved, twice: both halvings must show it.
template <class Error>
void expect_order(double order, const Error& error) {
  const double coarse = error(0.01), middle = error(0.005), fine = error(0.0025);
  EXPECT_NEAR(std::log2(coarse / middle), order, 0.15);
  EXPECT_NEAR(std::log2(middle / fine), order, 0.1);
}

// One body on a spring and dashpot (5 %) whose ground moves harmonically: its steady motion is kept.
double error_of_steady_motion(const Newmark& newmark, double dt) {
  using Complex = std::complex<double>;
  const double omega = 2 * M_PI, k = 40, m = 1, c = 0.1 * std::sqrt(k * m);
  Chain chain{{Body{}}, {}, {}, {}};
  chain.bodies[0].length = chain.bodies[0].mass = chain.bodies[0].inertia = 1;
  chain.bodies[0].ground_stiffness.lateral = k;
  chain.bodies[0].ground_dashpot.lateral = c;
  const Complex amplitude = (k + Complex(0, omega * c)) / (k - m * omega * omega + Complex(0, omega * c));
  const auto motion = [&](double t) { return amplitude * std::exp(Complex(0, omega * t)); };
  const double y0 = motion(0).real(), v0 = (Complex(0, omega) * motion(0)).real();

  Simulation run(chain, {.dt = dt, .newmark = newmark});
  double u = 1, v = 0;
  const auto ground = [&] { return Excitation{.ground_y = {&u, 1}, .ground_vy = {&v, 1}}; };
  run.start({.y = {&y0, 1}, .vy = {&v0, 1}}, ground());
  double worst = 0;
  while (run.time() < 3) {
    const double t = (run.steps() + 1) * dt;
    u = std::cos(omega * t);
    v = -omega * std::sin(omega * t);
    run.step(ground());
    worst = std::max(worst, std::abs(run.bodies().y[0] - motion(t).real()));
  }
  return worst;
}

TEST(Integrator, OrderForOneBodyOnMovingGround) {
  for (const Order& o : kOrders)
    expect_order(o.order, [&](double dt) { return error_of_steady_motion(o.newmark, dt); });
}

// A free chain of 8 bodies that swings in its third axial mode, cos(3 pi (i + 1/2) / 8), of frequency
// 2 sqrt(k/m) sin(3 pi / 16).
double error_of_mode(const Newmark& newmark, double dt) {
  const std::size_t n = 8;
  Chain chain = test::segments(n);
  const double omega = 2 * std::sqrt(2e9 / 9.5e6) * std::sin(3 * M_PI / 16);
  std::vector<double> mode(n);
  for (std::size_t i = 0; i < n; ++i) mode[i] = std::cos(3 * M_PI * (static_cast<double>(i) + 0.5) / 8);
  Simulation run(chain, {.dt = dt, .newmark = newmark});
  run.start({.x = mode});
  double worst = 0;
  while (run.time() < 1) {
    run.step({});
    for (std::size_t i = 0; i < n; ++i)
      worst = std::max(worst, std::abs(run.bodies().x[i] - mode[i] * std::cos(omega * run.time())));
  }
  return worst;
}

TEST(Integrator, OrderForAModeOfTheChain) {
  for (const Order& o : kOrders)
    expect_order(o.order, [&](double dt) { return error_of_mode(o.newmark, dt / 4); });
}

}  // namespace
}  // namespace adit::simplified::chain::integrator_test

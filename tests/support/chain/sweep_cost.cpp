#include "tests/support/chain/sweep_cost.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "simplified/chain/flush_denormals.hpp"
#include "simplified/chain/simulation.hpp"
#include "tests/support/chain/direct_integration.hpp"

namespace adit::simplified::chain::test {
namespace {

constexpr double kRing = 1.5;                         // length [m]
constexpr double kOuter = 6.8, kInner = 5.84;         // diameters [m]
constexpr double kDensity = 2500, kModulus = 34.5e9;  // of the concrete [kg/m^3], [Pa]
constexpr double kJoint = 0.1;                        // stiffness of a ring joint, against that of a ring
constexpr double kDt = 0.005;                         // [s]
constexpr double kWave = 1000;                        // apparent velocity [m/s]

// The ground under every body at time t: 0.1 m at 1 Hz along and across, running along the chain.
struct Wave {
  std::vector<double> x, y, vx, vy;
  explicit Wave(std::size_t n) : x(n), y(n), vx(n), vy(n) {}

  Excitation at(double t) {
    const double omega = 2 * M_PI;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double since = t - static_cast<double>(i) * kRing / kWave;
      const double arrived = since > 0 ? 0.1 : 0;
      x[i] = y[i] = arrived * (1 - std::cos(omega * since));
      vx[i] = vy[i] = arrived * omega * std::sin(omega * since);
    }
    return {.ground_x = x, .ground_y = y, .ground_vx = vx, .ground_vy = vy};
  }
};

double cpu_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Solver>
double seconds(Solver& solver, std::size_t bodies, long steps) {
  Wave wave(bodies);
  double spent = 0;
  for (long n = 1; n <= steps; ++n) {
    const Excitation excitation = wave.at(n * kDt);
    const double begin = cpu_seconds();
    solver.step(excitation);
    spent += cpu_seconds() - begin;
  }
  return spent;
}

}  // namespace

Chain rings(std::size_t n) {
  const double area = M_PI / 4 * (kOuter * kOuter - kInner * kInner);
  const double second_moment = M_PI / 64 * (std::pow(kOuter, 4) - std::pow(kInner, 4));
  Body ring;
  ring.length = kRing;
  ring.mass = kDensity * area * kRing;
  ring.inertia = kDensity * kRing * second_moment + ring.mass * kRing * kRing / 12;
  Hinge joint;
  joint.axial.stiffness = kJoint * kModulus * area / kRing;
  joint.shear.stiffness = 0.4 * joint.axial.stiffness;
  joint.rotation.stiffness = kJoint * kModulus * second_moment / kRing;
  joint.axial.dashpot = 1e-3 * joint.axial.stiffness;
  Chain chain{std::vector<Body>(n, ring), std::vector<Hinge>(n > 0 ? n - 1 : 0, joint), {}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    // Stiffness of the ground, 20 … 100 MPa, in lenses of some hundred metres.
    const double ground = (60e6 + 40e6 * std::sin(static_cast<double>(i) * kRing / 150)) * kRing;
    chain.bodies[i].ground_stiffness = {0.5 * ground, ground, 0.1 * ground * kOuter * kOuter};
    chain.bodies[i].ground_dashpot = {0.01 * ground, 0.02 * ground, 0};
  }
  return chain;
}

SweepCost sweep_cost(std::size_t bodies, long steps) {
  const Chain chain = rings(bodies);
  const Settings settings{.dt = kDt};
  const FlushDenormals fast;  // for both
  Simulation sweep(chain, settings);
  DirectIntegration direct(chain, settings);
  SweepCost result{bodies, steps, seconds(sweep, bodies, steps), seconds(direct, bodies, steps), 0};
  double largest = 0, difference = 0;
  const BodyMotion motion = sweep.bodies();
  for (std::size_t i = 0; i < bodies; ++i) {
    const std::vector<double>& other = direct.displacement();
    largest = std::max({largest, std::abs(other[3 * i]), std::abs(other[3 * i + 1])});
    difference = std::max(
        {difference, std::abs(motion.x[i] - other[3 * i]), std::abs(motion.y[i] - other[3 * i + 1])});
  }
  result.relative_difference = largest > 0 ? difference / largest : 0;
  return result;
}

}  // namespace adit::simplified::chain::test

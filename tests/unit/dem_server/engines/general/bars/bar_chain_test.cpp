// Requirements on a bar along its own axis.
#include "dem_server/engines/general/bars/bar_chain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace adit::dem::bar_chain_test {
namespace {

constexpr double kDiameter = 16e-3, kArea = 2e-4, kModulus = 200e9, kYield = 550e6;
constexpr double kUnbroken = 1e15;

BarBondLaw bond(double stiffness, double strength) {
  return {stiffness, strength, 1e-3, 2e-3, 10e-3, 0.4, 0.4};
}

// Nodes on the x axis, each in the middle of its length.
Bar straight(int nodes, double length, const BarBondLaw& law, double hardening = 0.01) {
  Bar bar{{}, false, {kModulus, kYield, hardening}, 0.05, kArea, kDiameter};
  const double h = length / nodes;
  for (int k = 0; k < nodes; ++k)
    bar.nodes.push_back({static_cast<std::uint32_t>(k), (k + 0.5) * h, 0, h, law, 1, 1});
  return bar;
}

// The slip under the force that pulls at the end of an elastic bar in elastic bond, over that force; the grip
// holds the bar at its end.
double pull_out_slip(int nodes, double length, double stiffness) {
  Bar bar = straight(nodes, length, bond(stiffness, kUnbroken));
  const double h = length / nodes;
  bar.nodes.push_back({0, length, 0, h, bond(1e6 * stiffness, kUnbroken), 1, 1});
  BarChain chain(bar);
  std::vector<double> growths(bar.elements(), 0.0);
  growths.back() = 1e-6;
  chain.stretch(growths);
  const double force = chain.force(bar.elements() - 1);
  return chain.slip(bar.nodes.size() - 2) / force;
}

// Pull-out of an elastic bar, EA s'' = k U s: the slip at x of a bar pulled at l is F cosh(a x) / (EA a
// sinh(a l)) with a^2 = k U / EA, which elements approach with the square of their length.
TEST(BarChain, IsPulledOutAsTheClosedForm) {
  constexpr double kLength = 0.4, kStiffness = 20e9;
  const double perimeter = 4 * kArea / kDiameter, a = std::sqrt(kStiffness * perimeter / (kModulus * kArea));
  std::vector<double> errors;
  for (const int nodes : {16, 32, 64}) {
    const double x = kLength * (1 - 0.5 / nodes);
    const double exact = std::cosh(a * x) / (kModulus * kArea * a * std::sinh(a * kLength));
    errors.push_back(std::abs(pull_out_slip(nodes, kLength, kStiffness) / exact - 1));
  }
  EXPECT_LT(errors[0], 0.01);
  EXPECT_GT(errors[0] / errors[1], 3.8);
  EXPECT_GT(errors[1] / errors[2], 3.8);
}

// A long bar in a plastic bond of constant stress is pulled by its bond stress times the length that slips.
TEST(BarChain, BondIsMobilisedOverTheLengthThatSlips) {
  BarBondLaw law = bond(2e12, 5e6);
  law.exponent = 0;
  Bar bar = straight(50, 0.5, law, 0.01);
  bar.nodes.back().bond = bond(1e16, kUnbroken);
  BarChain chain(bar);
  std::vector<double> growths(bar.elements(), 0.0);
  for (int i = 0; i < 200; ++i) {
    growths.back() += 2e-6;
    chain.stretch(growths);
  }
  double bonded = 0;
  for (std::size_t k = 0; k + 1 < bar.nodes.size(); ++k)
    bonded += chain.bond_stress(k) * bar.perimeter() * 0.01;
  const double force = chain.force(bar.elements() - 1);
  EXPECT_NEAR(std::abs(bonded), force, 1e-9 * force);
  // With n nodes sliding: N^2 / (2 EA U tau) is the slip at the loaded end.
  const double slip = force * force / (2 * kModulus * kArea * bar.perimeter() * 5e6);
  EXPECT_NEAR(std::abs(chain.slip(bar.nodes.size() - 2)), slip, 0.06 * slip);
}

// Held at both ends it yields at f_y, and hardens along b E.
TEST(BarChain, YieldsAndHardens) {
  const Bar bar = straight(2, 0.2, bond(1e18, kUnbroken), 0.02);
  BarChain chain(bar);
  for (const double strain : {1e-3, 2e-3, 1e-2}) {
    chain.stretch(std::vector{strain * 0.1});
    const double expected = std::min(kModulus * strain, kYield + 0.02 * (kModulus * strain - kYield));
    EXPECT_NEAR(chain.stress(0), expected, 1e-3 * expected);
  }
}

// Along a random way with yielding, slip and softening the work of the particles is what is stored and what
// is lost, to 1e-10 of the most that was ever stored or lost; and the bar is balanced at every node.
TEST(BarChain, KeepsItsLedger) {
  for (const bool closed : {false, true}) {
    Bar bar = straight(12, 1.2, bond(200e9, 8e6), 0.01);
    if (closed)
      for (std::size_t k = 0; k < bar.nodes.size(); ++k) {
        const double angle = 2 * 3.141592653589793 * static_cast<double>(k) / 12;
        bar.nodes[k].x = 0.2 * std::cos(angle);
        bar.nodes[k].y = 0.2 * std::sin(angle);
      }
    bar.closed = closed;
    BarChain chain(bar);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> goal(-3e-4, 6e-4);
    std::vector<double> growths(bar.elements(), 0.0), goals(growths), forces(growths);
    double work = 0, lost = 0, gross = 1;  // [J]
    for (int i = 0; i < 60; ++i) {
      for (double& one : goals) one = goal(random);
      const std::vector<double> from = growths;
      for (int n = 1; n <= 40; ++n) {
        std::vector<double> next = from;
        for (std::size_t k = 0; k < next.size(); ++k) next[k] += (goals[k] - from[k]) * n / 40;
        chain.stretch(next);
        for (std::size_t k = 0; k < next.size(); ++k) {
          work += (forces[k] + chain.force(k)) / 2 * (next[k] - growths[k]);
          forces[k] = chain.force(k);
        }
        growths = next;
        const double now = chain.yielded() + chain.slipped();
        EXPECT_GE(now, lost - 1e-12 * gross);
        lost = now;
        gross = std::max(gross, lost + chain.stored());
      }
      EXPECT_NEAR(work, chain.stored() + lost, 1e-10 * gross);
    }
    EXPECT_GT(chain.yielded(), 0);
    EXPECT_GT(chain.slipped(), 0);
    for (std::size_t k = 1; k + 1 < bar.nodes.size(); ++k)
      EXPECT_NEAR(chain.force(k) - chain.force(k - 1),
                  bar.perimeter() * bar.nodes[k].length * chain.bond_stress(k), 1e-9 * kArea * kYield);
  }
}

// The system of a ring is solved as that of a chain is.
TEST(Tridiagonal, SolvesChainsAndRings) {
  for (const bool ring : {false, true}) {
    Tridiagonal system{{5, 4, 6, 5, 7}, {-1, -2, -1.5, -2}};
    if (ring) system.off.push_back(-0.7);
    const std::vector<double> x{1, -2, 3, 0.5, -1};
    std::vector<double> right(5, 0.0);
    for (std::size_t k = 0; k < 5; ++k) {
      right[k] += system.diagonal[k] * x[k];
      if (k < system.off.size()) {
        right[k] += system.off[k] * x[(k + 1) % 5];
        right[(k + 1) % 5] += system.off[k] * x[k];
      }
    }
    system.solve(right);
    for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(right[k], x[k], 1e-13);
  }
}

}  // namespace
}  // namespace adit::dem::bar_chain_test

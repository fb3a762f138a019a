// Springs and dashpots between a point and moving ground: loops of slip, energy, dashpots of any size.
#include "protocol/foundation/springs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace adit::foundation::springs_test {
namespace {

// One point on a foundation, by central differences.
struct Point {
  Springs springs;
  double mass, velocity = 0, displacement = 0, force = 0, before = 0;

  void step(std::uint64_t number, double dt, double load = 0) {
    const protocol::Step step{number, dt};
    if (number > 0) displacement += dt * velocity;
    const double inverse = mass > 0 ? 1 / mass : 0;
    force = load;
    springs.pull(step, {&velocity, &inverse, &force});
    springs.brake(step, {&velocity, &inverse, &force});
    before = number > 0 ? velocity : -step.kick() * inverse * force;
    velocity += step.kick() * inverse * force;
  }
  double energy() const {
    return mass * before * velocity / 2 + springs.stored() + springs.dissipated() - springs.work();
  }
};

// The ground goes to and fro by twice the amplitude once a second, from rest.
std::shared_ptr<const GroundCourse> swinging(double amplitude) {
  const double omega = 2 * std::numbers::pi;
  std::vector<double> time, v, zero;
  for (int n = 0; n <= 4000; ++n) {
    time.push_back(n / 1000.);
    v.push_back(amplitude * omega * std::sin(omega * time.back()));
    zero.push_back(0);
  }
  return std::make_shared<const GroundCourse>(time, std::vector<double>{0}, v, zero, "swing");
}

// Requirement: a full cycle of amplitude a beyond the slip e_y = f/k takes 4 (1 - h) f (a - e_y) per area
// (Masing).
TEST(FoundationSprings, TakeTheAreaOfTheirLoop) {
  const SpringLaw law{1e6, 0, 4e3, 0.1};
  Point held{{Direction::kX, law, swinging(0.01), {{0, 2.5, 0}}}, 0};
  const auto cycle = [&](int from) {
    const double before = held.springs.dissipated();
    for (int n = from; n < from + 1000; ++n) held.step(static_cast<std::uint64_t>(n), 1e-3);
    return held.springs.dissipated() - before;
  };
  cycle(0);
  const double loop = cycle(1000);
  EXPECT_NEAR(loop, 2.5 * 4 * 0.9 * 4e3 * (0.01 - 4e-3), 1e-3 * loop);
}

// Requirement: without slip and dashpots nothing is lost; whatever the law, the energies balance to rounding.
TEST(FoundationSprings, BalanceTheirEnergy) {
  for (const SpringLaw& law : {SpringLaw{1e6, 0, HUGE_VAL, 0}, SpringLaw{1e6, 3e3, 2e3, 0.05}}) {
    Point point{{Direction::kX, law, swinging(0.01), {{0, 2, 0}}}, 500};
    point.step(0, 1e-3);
    const double start = point.energy();
    double largest = 0;
    for (std::uint64_t n = 1; n < 3000; ++n) {
      point.step(n, 1e-3);
      largest = std::max(largest, point.springs.work());
      ASSERT_NEAR(point.energy(), start, 1e-12 * std::max(1.0, largest)) << n;
    }
    EXPECT_GT(largest, 1);
    if (law.dashpot == 0)
      EXPECT_NEAR(point.springs.dissipated(), 0, 1e-12 * largest);
    else
      EXPECT_GT(point.springs.dissipated(), 1e-3 * largest);
  }
}

// Requirement: a dashpot of any size is stable and carries a point with the ground.
TEST(FoundationSprings, StayStableWithStiffDashpots) {
  Point point{{Direction::kX, {1, 1e9, HUGE_VAL, 0}, swinging(0.01), {{0, 1, 0}}}, 1};
  for (std::uint64_t n = 0; n < 1250; ++n) point.step(n, 1e-3);
  EXPECT_NEAR(point.displacement, 0.01, 1e-4);  // the middle of the second cycle's way out
}

// Requirement: springs that an interface takes are gone from the rest.
TEST(FoundationSprings, AreDividedBetweenInterfaceAndInterior) {
  Springs springs(Direction::kY, {1, 0, HUGE_VAL, 0}, std::make_shared<const GroundCourse>(),
                  {{0, 1, 0}, {1, 1, 1}, {2, 0, 2}});
  const Springs taken = springs.take({false, true, false});
  EXPECT_TRUE(taken.holds(1, 2));
  EXPECT_FALSE(taken.holds(0, 1));
  EXPECT_TRUE(springs.holds(0, 1));
  EXPECT_FALSE(springs.holds(1, 3));  // the third has no area
}

}  // namespace
}  // namespace adit::foundation::springs_test

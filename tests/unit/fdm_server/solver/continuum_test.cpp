// Requirements on the motion: energy, momentum, order of convergence, prescribed motions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "fdm_server/solver/continuum.hpp"
#include "fdm_server/zones/critical_step.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"

namespace adit::fdm::test::continuum_test {
namespace {

using std::numbers::pi;

const PlaneLaw kLaw = plane_strain(kYoung, kPoisson);

TimeFactor sine(double frequency) {
  return [frequency](double t) { return std::sin(2 * pi * frequency * t); };
}
double always(double /*t*/) {
  return 1;
}

std::vector<std::uint32_t> points_at_x(const Grid& grid, double x) {
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t i = 0; i < grid.x.size(); ++i)
    if (grid.x[i] == x) chosen.push_back(i);
  return chosen;
}

class ContinuumOfEachZone : public testing::TestWithParam<ZoneKind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, ContinuumOfEachZone, testing::ValuesIn(kKinds), [](const auto& kind) {
  return kind.param == ZoneKind::kAssumedStrain ? "AssumedStrain" : "MixedDiscretization";
});

// Kinetic + strain energy - external work keeps its first value to rounding over 10^4 steps, with weights,
// distorted zones, a load from the first instant, a fixed side and a shaken one; also where the points of an
// interface divide all of them.
void expect_exact_ledger(ZoneKind kind, const std::vector<std::uint32_t>& interface) {
  const Grid grid = distorted_grid({0, 4, 0, 1, 8, 3});
  std::vector<double> weights(grid.zones.size());
  for (std::size_t z = 0; z < weights.size(); ++z) weights[z] = 0.05 + 0.04 * static_cast<double>(z % 20);
  const auto masses = lumped_masses(grid, weights, kDensity);
  const auto left = points_at_x(grid, 0), right = points_at_x(grid, 4);
  const std::vector<double> fx(left.size(), 2e5), fy(left.size(), -1e5);
  Continuum continuum(
      ZoneSet(kind, grid, kLaw, weights), masses, {{left, fx, fy, always}},
      {{right, Axis::kX, 0.0, always}, {right, Axis::kY, 0.3, [](double t) { return std::cos(600 * t); }}});
  if (!interface.empty()) continuum.set_interface(interface);
  const double dt = 0.8 * critical_step(kind, grid, kLaw, kDensity);
  Energies first{}, e{};
  continuum.step({0, dt}, &first);
  double peak = 0, drift = 0;
  for (std::uint64_t n = 1; n <= 10000; ++n) {
    continuum.step({n, dt}, &e);
    peak = std::max({peak, e.kinetic, e.strain, std::abs(e.external_work)});
    const double ledger = e.kinetic + e.strain - e.external_work;
    drift = std::max(drift, std::abs(ledger - (first.kinetic + first.strain - first.external_work)));
  }
  EXPECT_GT(e.external_work, 0);
  EXPECT_LE(drift, 1e-12 * peak);
}

TEST_P(ContinuumOfEachZone, EnergyLedgerIsExact) {
  expect_exact_ledger(GetParam(), {});
  expect_exact_ledger(GetParam(), {0, 4, 8, 9, 13, 17, 22, 31});
}

// Without dissipation nothing tells the direction of time: from the reversed velocities of half a step
// before, the ground goes back the way it came, under steady loads, weights and a side that is held.
TEST_P(ContinuumOfEachZone, GoesBackTheWayItCame) {
  const Grid grid = distorted_grid({0, 4, 0, 1, 8, 3});
  const auto left = points_at_x(grid, 0), right = points_at_x(grid, 4);
  const std::vector<double> fx(left.size(), 2e5), fy(left.size(), -1e5);
  Continuum continuum(ZoneSet(GetParam(), grid, kLaw, ones(grid)), lumped_masses(grid, ones(grid), kDensity),
                      {{left, fx, fy, {}}}, {{right, Axis::kX, 0.0, always}});
  const double dt = 0.8 * critical_step(GetParam(), grid, kLaw, kDensity);
  constexpr std::uint64_t kSteps = 300;
  std::vector<std::vector<double>> way;  // x displacements of steps 1, 2, …
  std::vector<double> vx, vy;
  for (std::uint64_t n = 0; n <= kSteps; ++n) {
    vx.assign(continuum.vx().begin(), continuum.vx().end());
    vy.assign(continuum.vy().begin(), continuum.vy().end());
    continuum.step({n, dt});
    way.emplace_back(continuum.ux().begin(), continuum.ux().end());
  }
  for (std::size_t i = 0; i < vx.size(); ++i) {
    continuum.vx()[i] = -vx[i];
    continuum.vy()[i] = -vy[i];
  }
  double farthest = 0;
  for (std::uint64_t back = 1; back < kSteps; ++back) {
    continuum.step({kSteps + back, dt});
    for (std::size_t i = 0; i < vx.size(); ++i) {
      EXPECT_NEAR(continuum.ux()[i], way[kSteps - back][i], 1e-13) << back;
      farthest = std::max(farthest, std::abs(way[kSteps - back][i]));
    }
  }
  EXPECT_GT(farthest, 1e-4) << "the test would not see a motion that differs";
}

// A steady load is a load of constant factor: motion and ledger differ by rounding only.
TEST_P(ContinuumOfEachZone, SteadyLoadIsALoadOfConstantFactor) {
  const Grid grid = distorted_grid({0, 4, 0, 1, 8, 3});
  const auto masses = lumped_masses(grid, ones(grid), kDensity);
  Load gravity{{}, {}, std::vector<double>(masses.size(), 0.0), always};
  for (std::uint32_t i = 0; i < masses.size(); ++i) {
    gravity.points.push_back(i);
    gravity.fx.push_back(9.81 * masses[i]);
  }
  const PrescribedMotion fixed{points_at_x(grid, 0), Axis::kX, 0.0, always};
  const double dt = 0.8 * critical_step(GetParam(), grid, kLaw, kDensity);
  const auto run = [&](const TimeFactor& factor, std::span<const std::uint32_t> interface) {
    gravity.factor = factor;
    Continuum continuum(ZoneSet(GetParam(), grid, kLaw, ones(grid)), masses, {gravity}, {fixed});
    if (!interface.empty()) continuum.set_interface(interface);
    Energies e{};
    for (std::uint64_t n = 0; n <= 200; ++n) continuum.step({n, dt}, &e);
    return std::pair(e, std::vector(continuum.ux().begin(), continuum.ux().end()));
  };
  const auto [expected, ux] = run(always, {});
  const double largest = std::ranges::max(ux);
  EXPECT_GT(largest, 0);
  const std::vector<std::uint32_t> interface { 0, 4, 8, 9, 13, 17, 22, 31 };
  for (const auto& points : {std::vector<std::uint32_t>{}, interface}) {
    const auto [steady, steady_ux] = run(nullptr, points);
    EXPECT_NEAR(steady.external_work, expected.external_work, 1e-12 * expected.external_work);
    EXPECT_NEAR(steady.kinetic + steady.strain, expected.kinetic + expected.strain,
                1e-12 * expected.external_work);
    for (std::size_t i = 0; i < ux.size(); ++i) EXPECT_NEAR(steady_ux[i], ux[i], 1e-12 * largest);
  }
}

// A free block takes up the whole impulse of its load, and no more: momentum is conserved by the zones.
TEST_P(ContinuumOfEachZone, MomentumOfAFreeBlockIsTheImpulseOfItsLoad) {
  const Grid grid = distorted_grid({0, 3, 0, 2, 6, 4});
  const auto masses = lumped_masses(grid, ones(grid), kDensity);
  const double dt = 0.9 * critical_step(GetParam(), grid, kLaw, kDensity);
  const auto factor = sine(50);
  Continuum continuum(ZoneSet(GetParam(), grid, kLaw, ones(grid)), masses,
                      {{{0, 7}, {3e6, 1e6}, {0, -2e6}, factor}}, {});
  double impulse = 0;
  for (std::uint64_t n = 0; n <= 2000; ++n) {
    continuum.step({n, dt});
    impulse += (n == 0 ? dt / 2 : dt) * factor(static_cast<double>(n) * dt);
  }
  double px = 0, py = 0, scale = 0;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    px += masses[i] * continuum.vx()[i];
    py += masses[i] * continuum.vy()[i];
    scale += masses[i] * std::hypot(continuum.vx()[i], continuum.vy()[i]);
  }
  EXPECT_NEAR(px, 4e6 * impulse, 1e-12 * scale);
  EXPECT_NEAR(py, -2e6 * impulse, 1e-12 * scale);
}

// A rigid translation and a linear rotation of the velocities leave the zones unstressed: no force appears.
TEST_P(ContinuumOfEachZone, RigidMotionIsFree) {
  const Grid grid = distorted_grid({0, 3, 0, 2, 6, 4});
  const auto masses = lumped_masses(grid, ones(grid), kDensity);
  Continuum continuum(ZoneSet(GetParam(), grid, kLaw, ones(grid)), masses, {}, {});
  const double dt = 0.9 * critical_step(GetParam(), grid, kLaw, kDensity);
  continuum.step({0, dt});
  for (std::size_t i = 0; i < masses.size(); ++i) {
    continuum.vx()[i] = 1 - 2 * grid.y[i];
    continuum.vy()[i] = 3 + 2 * grid.x[i];
  }
  for (std::uint64_t n = 1; n <= 100; ++n) continuum.step({n, dt});
  for (std::size_t i = 0; i < masses.size(); ++i) {
    EXPECT_NEAR(continuum.vx()[i], 1 - 2 * grid.y[i], 1e-10);
    EXPECT_NEAR(continuum.uy()[i], 100 * dt * (3 + 2 * grid.x[i]), 1e-10);
  }
}

// Error of a standing compression wave, u = sin(pi x) sin(omega t), after 0.35 periods.
double standing_wave_error(ZoneKind kind, std::uint32_t zones) {
  const Grid grid = make_grid({0, 1, 0, 0.1, zones, 2});
  const auto masses = lumped_masses(grid, ones(grid), kDensity);
  std::vector<std::uint32_t> all(grid.x.size()), ends = points_at_x(grid, 0);
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  std::ranges::copy(points_at_x(grid, 1), std::back_inserter(ends));
  Continuum continuum(ZoneSet(kind, grid, kLaw, ones(grid)), masses, {},
                      {{all, Axis::kY, 0.0, always}, {ends, Axis::kX, 0.0, always}});
  const double omega = pi * std::sqrt((kLaw.bulk + kLaw.shear) / kDensity);
  const double end = 0.35 * 2 * pi / omega;
  const std::uint64_t steps = 4 * zones;
  const double dt = end / static_cast<double>(steps);
  continuum.step({0, dt});
  for (std::size_t i = 0; i < grid.x.size(); ++i)
    continuum.vx()[i] = omega * std::sin(pi * grid.x[i]) * std::cos(omega * dt / 2);
  for (const auto i : ends) continuum.vx()[i] = 0;
  for (std::uint64_t n = 1; n <= steps; ++n) continuum.step({n, dt});
  double error = 0;
  for (std::size_t i = 0; i < grid.x.size(); ++i)
    error = std::max(error, std::abs(continuum.ux()[i] - std::sin(pi * grid.x[i]) * std::sin(omega * end)));
  return error;
}

// The scheme is of second order in space and time together.
TEST_P(ContinuumOfEachZone, StandingCompressionWaveConvergesWithSecondOrder) {
  double coarse = standing_wave_error(GetParam(), 10);
  for (const std::uint32_t zones : {20u, 40u, 80u}) {
    const double fine = standing_wave_error(GetParam(), zones);
    EXPECT_GE(std::log2(coarse / fine), 1.9) << zones << " zones";
    coarse = fine;
  }
}

// A prescribed point moves as told, at half steps, and an impulse does not move it.
TEST(Motion, PrescribedPointsFollowTheirVelocity) {
  const Grid grid = make_grid({0, 2, 0, 1, 4, 2});
  const auto masses = lumped_masses(grid, ones(grid), kDensity);
  const auto left = points_at_x(grid, 0);
  Continuum continuum(ZoneSet(kKinds[0], grid, kLaw, ones(grid)), masses, {},
                      {{left, Axis::kX, 2.0, sine(100)}});
  const double dt = 1e-5;
  double u = 0;
  for (std::uint64_t n = 0; n < 500; ++n) {
    continuum.step({n, dt});
    EXPECT_NEAR(continuum.ux()[left[1]], u, 1e-15);
    const double expected = 2 * std::sin(2 * pi * 100 * (static_cast<double>(n) + 0.5) * dt);
    continuum.push(left[1], 1e3, 0);
    EXPECT_NEAR(continuum.vx()[left[1]], expected, 1e-14);
    u += dt * expected;
  }
}

// What comes to a velocity at once has no kinetic energy before, and afterwards gets just that by the work of
// its motion.
TEST(Motion, ThatBeginsAtOnceTakesItsKineticEnergyAsWork) {
  const Grid grid = make_grid({0, 2, 0, 1, 4, 2});
  const auto masses = lumped_masses(grid, ones(grid), kDensity);
  std::vector<std::uint32_t> all(masses.size());
  std::iota(all.begin(), all.end(), 0);
  Continuum continuum(ZoneSet(kKinds[0], grid, kLaw, ones(grid)), masses, {},
                      {{all, Axis::kX, 2.0, always}, {all, Axis::kY, 0.0, always}});
  const double expected = kDensity * 2 * 2.0 * 2.0 / 2;
  Energies e{};
  for (std::uint64_t n = 0; n < 3; ++n) {
    continuum.step({n, 1e-5}, &e);
    EXPECT_NEAR(e.kinetic, n == 0 ? 0 : expected, 1e-12 * expected) << n;
    EXPECT_NEAR(e.external_work, n == 0 ? 0 : expected, 1e-12 * expected) << n;
  }
}

// An impulse changes a free point's velocity by impulse / mass.
TEST(Motion, ImpulseIsDividedByTheMass) {
  const Grid grid = make_grid({0, 2, 0, 1, 4, 2});
  const auto masses = lumped_masses(grid, ones(grid), kDensity);
  Continuum continuum(ZoneSet(kKinds[0], grid, kLaw, ones(grid)), masses, {}, {});
  continuum.push(6, 10, -20);
  EXPECT_DOUBLE_EQ(continuum.vx()[6], 10 / masses[6]);
  EXPECT_DOUBLE_EQ(continuum.vy()[6], -20 / masses[6]);
}

// A zone of liquefied sand is squeezed from 1.6 s on by points that are too heavy to mind: its pressure after
// another 0.1 s, if it reconsolidates from `time` on.
double pressure_of_squeezed_sand(double time) {
  constexpr double kDt = 1e-4;
  Material sand{2000, 60e6, 0.3};
  sand.pm4sand = Pm4Sand{.relative_density = 0.55,
                         .modulus_coefficient = 677,
                         .contraction_rate = 0.4,
                         .reconsolidation_from = time};
  const Grid grid = make_grid({0, 1, 0, 1, 1, 1});
  const std::vector<double> weights{1}, masses(grid.x.size(), 1e15);
  Continuum continuum(ZoneSet(ZoneKind::kAssumedStrain, grid, Ground{{sand}, {0}}, weights), masses, {}, {});
  continuum.zones().set_stress(0, {-50e3, -100e3, 0});
  continuum.zones().begin_time();
  for (std::uint64_t n = 0; n < 17000; ++n) {
    for (std::size_t i = 0; i < grid.x.size(); ++i) {
      if (grid.y[i] == 0) continue;
      continuum.vx()[i] = n >= 16000 ? 0 : n % 4000 < 2000 ? 0.1 : -0.1;
      continuum.vy()[i] = n >= 16000 ? -0.02 : 0;
    }
    continuum.step({n, kDt});
  }
  return -continuum.zones().stress(0).yy;
}

TEST(Motion, TellsTheGroundTheTime) {
  const double never = pressure_of_squeezed_sand(HUGE_VAL), all_the_time = pressure_of_squeezed_sand(1.6);
  EXPECT_LT(all_the_time, 0.2 * never);
  const double half = pressure_of_squeezed_sand(1.65);
  EXPECT_GT(half, all_the_time);
  EXPECT_LT(half, never);
  EXPECT_EQ(pressure_of_squeezed_sand(1.8), never);
}

// The same run twice gives the same bits.
TEST(Motion, IsReproducibleToTheLastBit) {
  const auto run = [] {
    const Grid grid = distorted_grid({0, 4, 0, 1, 70, 5});
    const auto masses = lumped_masses(grid, ones(grid), kDensity);
    Continuum continuum(ZoneSet(kKinds[0], grid, kLaw, ones(grid)), masses, {{{0}, {1e6}, {2e6}, sine(70)}},
                        {});
    for (std::uint64_t n = 0; n < 300; ++n) continuum.step({n, 1e-6});
    return std::vector<double>(continuum.vx().begin(), continuum.vx().end());
  };
  EXPECT_EQ(run(), run());
}

}  // namespace
}  // namespace adit::fdm::test::continuum_test

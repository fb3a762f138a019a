// Requirements on the critical time step.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "fdm_server/solver/continuum.hpp"
#include "fdm_server/zones/critical_step.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"

namespace adit::fdm::test::critical_step_test {
namespace {

const PlaneLaw kLaw = plane_stress(kYoung, kPoisson);

// 2/omega_max of the assembled grid.
double exact_limit(ZoneKind kind, const Grid& grid, const std::vector<double>& masses) {
  Eigen::VectorXd root(2 * static_cast<Eigen::Index>(masses.size()));
  for (Eigen::Index i = 0; i < root.size(); ++i) root[i] = 1 / std::sqrt(masses[i / 2]);
  const Eigen::MatrixXd scaled =
      root.asDiagonal() * assembled_stiffness(kind, grid, kLaw) * root.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled, Eigen::EigenvaluesOnly);
  return 2 / std::sqrt(solver.eigenvalues().maxCoeff());
}

double exact_limit(ZoneKind kind, const Grid& grid) {
  return exact_limit(kind, grid, lumped_masses(grid, ones(grid), kDensity));
}

// Largest velocity after 1000 steps from a pattern that contains every mode.
double velocity_after_many_steps(ZoneKind kind, const Grid& grid, double dt) {
  const auto masses = lumped_masses(grid, ones(grid), kDensity);
  Continuum continuum(ZoneSet(kind, grid, kLaw, ones(grid)), masses, {}, {});
  continuum.step({0, dt});
  for (std::size_t i = 0; i < masses.size(); ++i) {
    continuum.vx()[i] = std::sin(1.7 * static_cast<double>(i * i));
    continuum.vy()[i] = std::cos(2.3 * static_cast<double>(i * i));
  }
  for (std::uint64_t n = 1; n <= 1000; ++n) continuum.step({n, dt});
  double largest = 0;
  for (std::size_t i = 0; i < masses.size(); ++i)
    largest = std::max({largest, std::abs(continuum.vx()[i]), std::abs(continuum.vy()[i])});
  return largest;
}

// The bound is on the safe side of the grid's own limit, and near it.
TEST(CriticalStep, IsALowerBoundOfTheExactLimit) {
  for (const auto kind : kKinds)
    for (const auto& grid : {make_grid({0, 5, 0, 1, 10, 4}), distorted_grid({0, 5, 0, 1, 10, 4})}) {
      const double bound = critical_step(kind, grid, kLaw, kDensity), exact = exact_limit(kind, grid);
      EXPECT_LE(bound, exact * (1 + 1e-12));
      EXPECT_GE(bound, 0.75 * exact);
    }
}

// Densities by which every zone has the same critical step make it a bound of the whole grid.
TEST(CriticalStep, OfZonesThatShareOneIsABoundOfTheGrid) {
  constexpr double kStep = 1e-4;
  const Grid grid = distorted_grid({0, 5, 0, 1, 10, 4});
  Ground ground{{{kDensity, kYoung, kPoisson}}, std::vector<std::uint32_t>(grid.zones.size(), 0)};
  ground.plane_stress = true;
  for (const auto kind : kKinds) {
    std::vector<double> densities;
    for (const double step : zone_steps(kind, grid, ground))
      densities.push_back(kDensity * std::pow(kStep / step, 2));
    const double exact = exact_limit(kind, grid, lumped_masses(grid, ones(grid), densities));
    EXPECT_LE(kStep, exact * (1 + 1e-12));
    EXPECT_GE(kStep, 0.75 * exact);
  }
}

// The exact limit divides stable from unstable motion.
TEST(CriticalStep, ExactLimitSeparatesStableFromUnstable) {
  for (const auto kind : kKinds) {
    const Grid grid = make_grid({0, 2, 0, 1, 5, 4});
    const double exact = exact_limit(kind, grid);
    EXPECT_LE(velocity_after_many_steps(kind, grid, 0.99 * exact), 100);
    EXPECT_GE(velocity_after_many_steps(kind, grid, 1.01 * exact), 1e6);
  }
}

// One bad zone decides, wherever it is.
TEST(CriticalStep, SmallestZoneDecides) {
  Grid grid = make_grid({0, 4, 0, 1, 4, 1});
  const double regular = critical_step(kKinds[0], grid, kLaw, kDensity);
  grid.x[2] -= 0.6;
  EXPECT_LT(critical_step(kKinds[0], grid, kLaw, kDensity), 0.8 * regular);
}

// A stiffness beyond all numbers allows no step, also of one zone among others.
TEST(CriticalStep, IsNoneForAStiffnessBeyondAllNumbers) {
  const double huge = std::numeric_limits<double>::infinity();
  const Ground ground{{{kDensity, kYoung, kPoisson}, {kDensity, huge, kPoisson}}, {0, 1}};
  for (const ZoneKind kind : kKinds) EXPECT_EQ(critical_step(kind, make_grid({0, 2, 0, 1, 2, 1}), ground), 0);
}

}  // namespace
}  // namespace adit::fdm::test::critical_step_test

// Young's modulus and Poisson's ratio of lattices of contact bonds, from bars that are pulled.
//
// A bar's stiffness is the solid's times its height, but for what its two surfaces take away: the difference
// of two bars of unequal height is free of it.
#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>

#include "dem_server/model/calibration.hpp"
#include "tests/unit/dem_server/engines/lattice/lattice.hpp"

namespace adit::dem::moduli_test {
namespace {

constexpr double kRadius = 0.5, kHeightOfRow = std::numbers::sqrt3 * kRadius;
constexpr int kDiscs = 60;
constexpr double kYoung = 25e9;

// A bar pulled at both ends by a unit strain, free across: the force, and the strains half-way.
struct Pulled {
  double force, along, across;
};

Pulled pull(int rows, const BondStiffness& stiffness) {
  const ContactBond law{stiffness, kUnbreakable, kUnbreakable};
  const Assembly bar = test::assemble(test::rows_of(rows, kDiscs, kRadius), 1.0);
  const Particles& p = bar.particles;
  const auto size = static_cast<Eigen::Index>(p.size());
  const Eigen::SparseMatrix<double> k = test::stiffness_matrix(law, bar);
  // At both ends the discs move in proportion to their place; one disc is held across the bar.
  Eigen::VectorXd given = Eigen::VectorXd::Zero(3 * size);
  std::vector<bool> held(3 * p.size(), false);
  const double middle = kRadius * kDiscs;
  for (Eigen::Index i = 0; i < size; ++i)
    if (const double from_middle = p.x[i] - middle; std::abs(from_middle) > middle - 2.5 * kRadius) {
      held[3 * i] = true;
      given[3 * i] = from_middle;
    }
  held[1] = true;
  Eigen::SparseMatrix<double> inner = k;
  inner.prune([&held](Eigen::Index i, Eigen::Index j, double) { return !held[i] && !held[j]; });
  for (Eigen::Index i = 0; i < 3 * size; ++i)
    if (held[i]) inner.coeffRef(i, i) = 1;
  Eigen::VectorXd right = -(k * given);
  for (Eigen::Index i = 0; i < 3 * size; ++i)
    if (held[i]) right[i] = 0;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(inner);
  EXPECT_EQ(solver.info(), Eigen::Success);
  const Eigen::VectorXd moved = given + solver.solve(right), forces = k * moved;

  Pulled result{};
  for (Eigen::Index i = 0; i < size; ++i)
    if (held[3 * i] && p.x[i] > middle) result.force += forces[3 * i];
  // Least squares of the displacements in the middle third.
  double xx = 0, xu = 0, yy = 0, yv = 0, count = 0, y_mean = 0, v_mean = 0;
  const auto in_the_middle = [&](Eigen::Index i) { return std::abs(p.x[i] - middle) < kDiscs * kRadius / 3; };
  for (Eigen::Index i = 0; i < size; ++i)
    if (in_the_middle(i)) count += 1, y_mean += p.y[i], v_mean += moved[3 * i + 1];
  for (Eigen::Index i = 0; i < size; ++i)
    if (in_the_middle(i)) {
      const double x = p.x[i] - middle, y = p.y[i] - y_mean / count;
      xx += x * x, xu += x * moved[3 * i];
      yy += y * y, yv += y * (moved[3 * i + 1] - v_mean / count);
    }
  result.along = xu / xx;
  result.across = yv / yy;
  return result;
}

// E and nu of the hexagonal lattice are those that it was calibrated to, far within 0.1 %.
TEST(Moduli, OfTheHexagonalLattice) {
  for (const double poisson_ratio : {0.0, 0.1, 0.2, 0.3}) {
    const BondStiffness stiffness = calibrate(kYoung, poisson_ratio, Plane::kStress);
    const Pulled low = pull(7, stiffness), high = pull(13, stiffness);
    const double young = (high.force / high.along - low.force / low.along) / (6 * kHeightOfRow);
    EXPECT_NEAR(young / kYoung, 1, 1e-5) << "Poisson's ratio " << poisson_ratio;
    EXPECT_NEAR(-high.across / high.along, poisson_ratio, 1e-5);
  }
}

}  // namespace
}  // namespace adit::dem::moduli_test

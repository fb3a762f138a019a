// A column of parallel-bonded discs is a beam.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/unit/dem_server/discs_models.hpp"

namespace adit::dem::column_test {
namespace {

constexpr double kRadius = 0.05, kNormal = 3e11, kShear = 1.2e11;
constexpr double kArea = 2 * kRadius, kSecondMoment = 2 * kRadius * kRadius * kRadius / 3;

Model column(int discs) {
  std::vector<std::array<double, 3>> places;
  for (int i = 0; i < discs; ++i) places.push_back({0, 2 * kRadius * i, kRadius});
  Model model = test::loose_discs(places, {0, 0, 0});
  model.parallel_bonds = {{kNormal, kShear, kRadius, INFINITY, INFINITY, 0}};
  test::join(model, Bond::Law::kParallelBond);
  return model;
}

// Forces and moments against a small displacement of each component (x, y, turn of each disc but the first,
// which is held), as the solver gives them after one step of that velocity, less those without any.
Eigen::MatrixXd stiffness_matrix(const Model& model) {
  const auto size = static_cast<Eigen::Index>(3 * (model.discs.size() - 1));
  Eigen::MatrixXd k(size, size);
  Solver still(model, 1);
  PrescribedMotions motions;
  still.step({1, 1e-9}, test::no_loads, motions);
  const Particles& rest = still.particles();
  for (Eigen::Index column = 0; column < size; ++column) {
    Solver solver(model, 1);
    Particles& p = solver.particles();
    std::vector<double>* const velocities[] = {&p.vx, &p.vy, &p.spin};
    constexpr double kSmall = 1e-9;
    (*velocities[column % 3])[static_cast<std::size_t>(column / 3 + 1)] = kSmall;
    PrescribedMotions none;
    solver.step({1, 1.0}, test::no_loads, none);
    for (Eigen::Index row = 0; row < size; row += 3) {
      const auto i = static_cast<std::size_t>(row / 3 + 1);
      k(row, column) = (rest.fx[i] - p.fx[i]) / kSmall;
      k(row + 1, column) = (rest.fy[i] - p.fy[i]) / kSmall;
      k(row + 2, column) = (rest.moment[i] - p.moment[i]) / kSmall;
    }
  }
  return k;
}

// Held at its foot and loaded at the other end, to 0.1 % of beam theory with shear: P L / EA, P L^3 / 3 EI +
// P L / GA, and where no disc may turn P L / GA alone; EA = kn A 2R, EI = kn I 2R, GA = ks A 2R.
TEST(DiscsColumn, AxialBendingAndShearStiffness) {
  constexpr int kBonds = 20;
  const Eigen::MatrixXd k = stiffness_matrix(column(kBonds + 1));
  const double length = 2 * kRadius * kBonds, ea = kNormal * kArea * 2 * kRadius,
               ei = kNormal * kSecondMoment * 2 * kRadius, ga = kShear * kArea * 2 * kRadius;
  const Eigen::Index tip = k.rows() - 3;
  const Eigen::VectorXd pulled = k.lu().solve(Eigen::VectorXd::Unit(k.rows(), tip + 1));
  EXPECT_NEAR(pulled[tip + 1] * ea / length, 1, 1e-3);
  const Eigen::VectorXd bent = k.lu().solve(Eigen::VectorXd::Unit(k.rows(), tip));
  EXPECT_NEAR(bent[tip] / (length * length * length / (3 * ei) + length / ga), 1, 1e-3);

  Eigen::MatrixXd upright(kBonds, kBonds);
  for (int i = 0; i < kBonds; ++i)
    for (int j = 0; j < kBonds; ++j) upright(i, j) = k(3 * i, 3 * j);
  const Eigen::VectorXd sheared = upright.lu().solve(Eigen::VectorXd::Unit(kBonds, kBonds - 1));
  EXPECT_NEAR(sheared[kBonds - 1] * ga / length, 1, 1e-3);
}

// The first three frequencies of the cantilever, to 1 % of beam theory: w = b^2 sqrt(EI / (m' L^4)).
TEST(DiscsColumn, FirstThreeFrequencies) {
  constexpr int kBonds = 60;
  const Model model = column(kBonds + 1);
  const Eigen::MatrixXd k = stiffness_matrix(model);
  Eigen::VectorXd mass(k.rows());
  for (Eigen::Index row = 0; row < k.rows(); ++row)
    mass[row] = row % 3 == 2 ? model.inertia(1) : model.mass[1];
  const Eigen::MatrixXd root = mass.cwiseSqrt().cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(root * k * root);
  // From the held centre to the free end, half a disc beyond the last centre.
  const double length = 2 * kRadius * (kBonds + 0.5), ei = kNormal * kSecondMoment * 2 * kRadius;
  const double line_mass = model.mass[1] / (2 * kRadius);
  const double roots[] = {1.87510407, 4.69409113, 7.85475744};
  for (int mode = 0; mode < 3; ++mode) {
    const double expected = roots[mode] * roots[mode] * std::sqrt(ei / line_mass) / (length * length);
    EXPECT_NEAR(std::sqrt(modes.eigenvalues()[mode]) / expected, 1, 0.01) << mode;
  }
  // The bound of the time step holds for the whole column.
  EXPECT_LE(critical_step(model), 2 / std::sqrt(modes.eigenvalues().maxCoeff()) * (1 + 1e-9));
}

// Discs of sizes 1:4, bonds of both kinds and contacts in any order: no frequency is above the bound of the
// time step. It counts as many contacts as there is room for, and so stays within a factor of ten of what
// these few need.
TEST(DiscsColumn, TheTimeStepsBoundHoldsForAnyDiscs) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(0, 1);
    std::vector<std::array<double, 3>> places;
    for (int row = 0; row < 6; ++row)
      for (int column = 0; column < 6; ++column)
        places.push_back({0.1 * (column + 0.2 * any(random)), 0.1 * (row + 0.2 * any(random)),
                          0.07 * (0.25 + 0.75 * any(random))});
    Model model = test::loose_discs(places, {1e9, 8e8, 1e9});
    model.overlaps_free = false;
    model.parallel_bonds = {{2e10, 1e10, 0.03, INFINITY, INFINITY, 0}};
    model.contact_bonds = {{3e9, 1e9}};
    for (const Pair& pair : pairs_within(model.discs, 0)) {
      const double lot = any(random);
      if (lot < 0.6)
        model.bonds.push_back(
            {pair.first, pair.second, lot < 0.3 ? Bond::Law::kParallelBond : Bond::Law::kContactBond, 0});
    }
    Eigen::MatrixXd k = stiffness_matrix(model);
    Eigen::VectorXd mass(k.rows());
    for (Eigen::Index row = 0; row < k.rows(); ++row) {
      const auto i = static_cast<std::size_t>(row / 3 + 1);
      mass[row] = row % 3 == 2 ? model.inertia(i) : model.mass[i];
    }
    const Eigen::MatrixXd root = mass.cwiseSqrt().cwiseInverse().asDiagonal();
    const Eigen::MatrixXd symmetric = root * (k + k.transpose()) * root / 2;
    const double highest = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric).eigenvalues().maxCoeff();
    EXPECT_LE(critical_step(model), 2 / std::sqrt(highest));
    EXPECT_GE(critical_step(model), 0.1 * 2 / std::sqrt(highest));
  }
}

}  // namespace
}  // namespace adit::dem::column_test

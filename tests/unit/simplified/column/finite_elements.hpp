// An independent model of a deposit on rigid rock: finite elements with quadratic shapes.
#pragma once

#include <Eigen/Eigenvalues>
#include <cmath>
#include <vector>

#include "simplified/column/modes/deposit.hpp"

namespace adit::simplified::column::test {

struct FiniteElementModes {
  Eigen::VectorXd frequencies;     // [rad/s]
  Eigen::VectorXd participations;  // psi_n at the surface
  Eigen::VectorXd masses;          // effective [kg/m^2]
};

inline FiniteElementModes finite_element_modes(const Deposit& deposit, int elements_per_layer) {
  const auto layers = static_cast<Eigen::Index>(deposit.layers.size());
  const Eigen::Index points = 2 * elements_per_layer * layers + 1;
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(points, points), mass = stiffness;
  Eigen::Matrix3d k, m;
  k << 7, -8, 1, -8, 16, -8, 1, -8, 7;
  m << 4, 2, -1, 2, 16, 2, -1, 2, 4;
  for (Eigen::Index i = 0; i < layers; ++i) {
    const Layer& layer = deposit.layers[static_cast<std::size_t>(i)];
    const double h = layer.thickness / elements_per_layer;
    for (Eigen::Index e = i * elements_per_layer; e < (i + 1) * elements_per_layer; ++e) {
      stiffness.block(2 * e, 2 * e, 3, 3) += layer.modulus() / (3 * h) * k;
      mass.block(2 * e, 2 * e, 3, 3) += layer.density * h / 30 * m;
    }
  }
  const Eigen::VectorXd load = (mass * Eigen::VectorXd::Ones(points)).head(points - 1);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      stiffness.topLeftCorner(points - 1, points - 1), mass.topLeftCorner(points - 1, points - 1));
  const Eigen::VectorXd factors = solver.eigenvectors().transpose() * load;
  return {solver.eigenvalues().cwiseSqrt(), factors.cwiseProduct(solver.eigenvectors().row(0).transpose()),
          factors.cwiseAbs2()};
}

}  // namespace adit::simplified::column::test

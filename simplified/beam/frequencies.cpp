#include "simplified/beam/frequencies.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "protocol/errors.hpp"
#include "simplified/beam/stepper.hpp"

namespace adit::simplified::beam {
namespace {

constexpr double kTolerance = 1e-12;  // relative change of the largest wanted eigenvalue
constexpr int kIterations = 1000;

Eigen::MatrixXd product(const BlockTridiagonal& matrix, const Eigen::MatrixXd& x) {
  Eigen::MatrixXd y(x.rows(), x.cols());
  const std::size_t n = x.rows();
  for (Eigen::Index j = 0; j < x.cols(); ++j)
    matrix.multiply(std::span(x.col(j).data(), n), std::span(y.col(j).data(), n));
  return y;
}

// Start vectors to which no mode is orthogonal: cosines along the axis in all directions, each with another
// phase.
Eigen::MatrixXd start_vectors(std::size_t dofs, int count) {
  Eigen::MatrixXd x(dofs, count);
  for (int j = 0; j < count; ++j)
    for (std::size_t i = 0; i < dofs; ++i)
      x(i, j) =
          std::cos(0.7 * j + (j / 3 + 1) * 3.1 * static_cast<double>(i) / dofs + 1.3 * (i % kDofs) * (j + 1));
  return x;
}

}  // namespace

std::vector<double> frequencies(const Tunnel& tunnel, int count) {
  check(tunnel);
  if (!tunnel.inertia)
    throw protocol::UserError("inertia", "a tube without inertia has no frequencies: switch inertia on");
  const Structure structure(tunnel);
  const int free_dofs = static_cast<int>(structure.dofs() - kDofs * structure.fixed_nodes.size());
  if (count < 1 || count > free_dofs)
    throw protocol::UserError("count", fmt::format("{} frequencies are asked for, but the model has {} free "
                                                   "degrees of freedom; ask for at most that many",
                                                   count, free_dofs));

  // The tangent stiffness in the installed state.
  SoilSprings soil(tunnel, structure.mesh, structure.elements);
  JointSprings joints(tunnel, structure.mesh);
  const std::vector<double> rest(structure.dofs());
  std::vector<double> forces(structure.dofs());
  GroundState ground;
  for (auto* kind : {&ground.displacement, &ground.velocity})
    for (auto& values : *kind) values.assign(soil.chainages().size() + 2 * SoilSprings::first_support, 0.0);
  // With Newmark's scheme the tangents are those of the springs themselves; the energy-conserving scheme
  // would give those of mean forces, which are half as large.
  soil.evaluate(newmark(), rest, rest, ground, forces);
  joints.evaluate(newmark(), rest, forces);
  BlockTridiagonal stiffness = structure.stiffness, mass = structure.mass;
  soil.update_tangents(stiffness);
  joints.update_tangents(stiffness);
  structure.fix(stiffness);
  BlockCholesky factor;
  if (factor.factor(stiffness))
    throw protocol::UserError("soil", "the tube is free to move: give the soil springs a stiffness");

  // Subspace iteration: X ← K⁻¹ M X, then Rayleigh–Ritz.
  // Eight vectors more than wanted speed the iteration up: it converges with the ratio of the highest wanted
  // eigenvalue to the first one that the vectors do not hold.
  Eigen::MatrixXd x = start_vectors(structure.dofs(), std::min(free_dofs, count + 8));
  Eigen::VectorXd values = Eigen::VectorXd::Zero(count);
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    x = product(mass, x);
    for (Eigen::Index j = 0; j < x.cols(); ++j) {
      std::span column(x.col(j).data(), structure.dofs());
      structure.clear_fixed(column);
      factor.solve(column);
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> ritz(
        x.transpose() * product(stiffness, x), x.transpose() * product(mass, x));
    x *= ritz.eigenvectors();
    const Eigen::VectorXd next = ritz.eigenvalues().head(count);
    const bool settled = ((next - values).array().abs() <= kTolerance * next.array()).all();
    values = next;
    if (settled) break;
  }
  std::vector<double> omega;
  for (const double value : values) omega.push_back(std::sqrt(value));
  return omega;
}

}  // namespace adit::simplified::beam

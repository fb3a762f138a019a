#include "simplified/column/response/chain.hpp"

#include <Eigen/LU>
#include <cmath>

namespace adit::simplified::column {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

struct Lanczos {
  MatrixXd vectors;    // Q
  VectorXd couplings;  // beta: the off-diagonal entries of Q^T A Q are -beta
};

// The tridiagonal form of the diagonal matrix A by Lanczos' method from the vector `start`. Orthogonalization
// is full and done twice, so that rounding errors do not destroy it.
Lanczos lanczos(const VectorXd& A, const VectorXd& start) {
  const Index n = A.size();
  Lanczos result{MatrixXd(n, n), VectorXd(n - 1)};
  result.vectors.col(0) = start.normalized();
  for (Index i = 1; i < n; ++i) {
    const auto before = result.vectors.leftCols(i);
    VectorXd next = A.cwiseProduct(before.col(i - 1));
    for (int pass = 0; pass < 2; ++pass) next -= before * (before.transpose() * next);
    result.couplings[i - 1] = next.norm();
    result.vectors.col(i) = -next / next.norm();
  }
  return result;
}

MatrixXd stiffness_of(const VectorXd& springs) {
  const Index n = springs.size();
  MatrixXd stiffness = MatrixXd::Zero(n, n);
  for (Index i = 0; i < n; ++i) {
    stiffness(i, i) += springs[i];
    if (i == 0) continue;
    stiffness(i - 1, i - 1) += springs[i];
    stiffness(i - 1, i) = stiffness(i, i - 1) = -springs[i];
  }
  return stiffness;
}

}  // namespace

// Solves an inverse eigenvalue problem. With x_n = sqrt(M_n) q_n the oscillators obey x'' + A x = -r a, where
// A = diag(omega_n^2) and r_n = sqrt(M_n), and act on the base with r^T A x. With y_i = sqrt(m_i) v_i a chain
// of masses m obeys y'' + T y = -s a, where s_i = sqrt(m_i) and T is tridiagonal with negative off-diagonal
// entries, and acts on the base with s^T T y. The two systems are the same if y = Q^T x with an orthogonal Q,
// T = Q^T A Q and s = Q^T r. A common displacement of all masses strains only the spring at the base: T s =
// e_0 k_0/s_0, that is A r = q_0 k_0/s_0. So q_0 has the direction of A r, and Lanczos' method gives the
// other columns of Q. All s_i are positive, because T^-1 has positive entries only, and so are all springs:
// k_0 = s^T T s = sum K_n, k_i = beta_i s_i-1 s_i.
Chain equivalent_chain(const ModalColumn& column) {
  const auto n = static_cast<Index>(column.modes.size());
  VectorXd frequencies(n), damping(n), roots(n);
  for (Index i = 0; i < n; ++i) {
    const Mode& mode = column.modes[static_cast<std::size_t>(i)];
    frequencies[i] = mode.frequency;
    damping[i] = mode.damping;
    roots[i] = std::sqrt(mode.effective_mass);
  }
  const VectorXd A = frequencies.cwiseAbs2();
  const auto [Q, couplings] = lanczos(A, A.cwiseProduct(roots));
  const VectorXd s = Q.transpose() * roots;

  Chain chain;
  chain.rigid_mass = column.rigid_mass;
  chain.masses = s.cwiseAbs2();
  chain.springs.resize(n);
  chain.springs[0] = A.dot(roots.cwiseAbs2());
  for (Index i = 1; i < n; ++i) chain.springs[i] = couplings[i - 1] * s[i - 1] * s[i];
  chain.stiffness = stiffness_of(chain.springs);
  const MatrixXd to_oscillators = Q * s.asDiagonal();  // x = Q S v
  chain.loss = to_oscillators.transpose() * (2 * damping.cwiseProduct(A)).asDiagonal() * to_oscillators;
  chain.dashpots =
      to_oscillators.transpose() * (2 * damping.cwiseProduct(frequencies)).asDiagonal() * to_oscillators;
  chain.oscillators = roots.cwiseInverse().asDiagonal() * to_oscillators;
  return chain;
}

namespace {

// v divided by the displacement of the base, from (K + i L - omega^2 M) v = omega^2 M 1.
Eigen::VectorXcd masses_over_base(const Chain& chain, double frequency) {
  Eigen::MatrixXcd dynamic = chain.stiffness + Complex(0, 1) * chain.loss;
  dynamic.diagonal() -= frequency * frequency * chain.masses;
  const Eigen::VectorXcd load = frequency * frequency * chain.masses.cast<Complex>();
  // The matrix is complex and symmetric but not Hermitian, and above the first mode it is not definite, so
  // Cholesky's method does not apply.
  return dynamic.partialPivLu().solve(load);
}

}  // namespace

Complex base_stiffness(const Chain& chain, double frequency) {
  const Eigen::VectorXcd v = masses_over_base(chain, frequency);
  return -frequency * frequency *
         (chain.rigid_mass + chain.masses.sum() + (chain.masses.cast<Complex>().transpose() * v).value());
}

Complex base_transfer(const Chain& chain, double frequency, const std::vector<double>& shapes) {
  const VectorXd psi = VectorXd::Map(shapes.data(), static_cast<Index>(shapes.size()));
  const VectorXd of_masses = chain.oscillators.transpose() * psi;
  return 1.0 + (of_masses.cast<Complex>().transpose() * masses_over_base(chain, frequency)).value();
}

}  // namespace adit::simplified::column

// Factors of a sparse matrix that is not symmetric, whose values change at every step: KLU, which keeps the
// places of all entries and finds new values alone. One of a lining that slides takes an eighth of the time
// of Eigen::SparseLU, whose dense blocks do not pay where rows have few entries.
#pragma once

#include <Eigen/KLUSupport>
#include <stdexcept>

namespace adit::fdm {

class SkewFactor : private Eigen::KLU<Eigen::SparseMatrix<double>> {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  SkewFactor() {
    // Pivots stay on the diagonal, and rows are not scaled, else rows of unlike units would be compared.
    kluCommon().tol = 0;
    kluCommon().scale = 0;
  }

  // The pattern must be the same at every call. Returns whether the factors could be found.
  bool factor(Matrix& matrix) {
    if (m_numeric == nullptr) compute(matrix);
    // Always by this, so that the factors do not depend on what was factored before.
    return info() == Eigen::Success &&
           klu_refactor(matrix.outerIndexPtr(), matrix.innerIndexPtr(), matrix.valuePtr(), m_symbolic,
                        m_numeric, &kluCommon()) != 0;
  }

  // x: the right-hand side, then the solution.
  void solve(Eigen::VectorXd& x) {
    klu_solve(m_symbolic, m_numeric, static_cast<int>(x.size()), 1, x.data(), &kluCommon());
  }
};

}  // namespace adit::fdm

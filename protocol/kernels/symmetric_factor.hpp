// A sparse symmetric positive definite matrix P A Pᵀ = L D Lᵀ, factored once (approximate minimum degree
// ordering, Eigen) and solved many times.
//
// Eigen's own solve allocates memory in every call and reads L once for each right-hand side. This one
// allocates nothing and solves for x and y together in one pass through L.
#pragma once

#include <Eigen/SparseCholesky>
#include <cstddef>
#include <vector>

namespace adit::protocol {

class SymmetricFactor {
 public:
  // Reads the lower triangle. Throws std::logic_error if the matrix is not positive definite.
  explicit SymmetricFactor(const Eigen::SparseMatrix<double>& lower);

  Eigen::Index size() const { return pivots_.size(); }
  // The place of a row of the matrix in the factor; the rows of a right-hand side stand in the order of the
  // places.
  int place(Eigen::Index row) const { return places_[static_cast<std::size_t>(row)]; }
  std::size_t bytes() const;

  // x := (P A Pᵀ)⁻¹ x, for one right-hand side (Sides = 1) or a pair (2), one column for each place.
  template <int Sides>
  void solve(Eigen::Array<double, Sides, Eigen::Dynamic>& x) const {
    using Row = Eigen::Array<double, Sides, 1>;
    for (Eigen::Index j = 0; j < size(); ++j) {
      const Row known = x.col(j);
      for (Entry entry(lower_, j); entry; ++entry) x.col(entry.row()) -= entry.value() * known;
    }
    for (Eigen::Index j = size() - 1; j >= 0; --j) {
      Row sum = x.col(j) / pivots_[j];
      for (Entry entry(lower_, j); entry; ++entry) sum -= entry.value() * x.col(entry.row());
      x.col(j) = sum;
    }
  }

 private:
  using Entry = Eigen::SparseMatrix<double>::InnerIterator;
  Eigen::SparseMatrix<double> lower_;  // L without its unit diagonal
  Eigen::VectorXd pivots_;             // D
  std::vector<int> places_;            // P
};

}  // namespace adit::protocol

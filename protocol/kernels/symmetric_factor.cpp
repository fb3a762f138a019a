#include "protocol/kernels/symmetric_factor.hpp"

#include <stdexcept>

namespace adit::protocol {

SymmetricFactor::SymmetricFactor(const Eigen::SparseMatrix<double>& lower) {
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> factor(lower);
  pivots_ = factor.vectorD();
  // Eigen's L D L^T also factors indefinite matrices, so the signs of the pivots are checked here.
  if (factor.info() != Eigen::Success || (size() > 0 && !(pivots_.minCoeff() > 0)))
    throw std::logic_error("a matrix is not positive definite");
  lower_ = factor.matrixL().nestedExpression();
  const auto& places = factor.permutationP().indices();
  places_.assign(places.begin(), places.end());
}

std::size_t SymmetricFactor::bytes() const {
  const auto entries = static_cast<std::size_t>(lower_.nonZeros()), rows = static_cast<std::size_t>(size());
  return entries * (sizeof(double) + sizeof(int)) + rows * (sizeof(double) + 2 * sizeof(int));
}

}  // namespace adit::protocol

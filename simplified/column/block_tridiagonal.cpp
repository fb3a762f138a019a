#include "simplified/column/block_tridiagonal.hpp"

#include <Eigen/Cholesky>
#include <stdexcept>
#include <string>
#include <utility>

namespace adit::simplified::column {

BlockTridiagonal::BlockTridiagonal(std::span<const std::size_t> block_sizes)
    : sizes_(block_sizes.begin(), block_sizes.end()) {
  std::size_t row = 0, diagonal = 0, upper = 0;
  for (std::size_t j = 0; j < sizes_.size(); ++j) {
    first_.push_back(row);
    diagonal_begin_.push_back(diagonal);
    upper_begin_.push_back(upper);
    row += sizes_[j];
    diagonal += sizes_[j] * sizes_[j];
    if (j + 1 < sizes_.size()) upper += sizes_[j] * sizes_[j + 1];
  }
  diagonal_values_.resize(diagonal);
  upper_values_.resize(upper);
}

BlockTridiagonal::Block BlockTridiagonal::diagonal(std::size_t block) {
  const auto n = static_cast<Eigen::Index>(sizes_[block]);
  return {diagonal_values_.data() + diagonal_begin_[block], n, n};
}

BlockTridiagonal::Block BlockTridiagonal::upper(std::size_t block) {
  return {upper_values_.data() + upper_begin_[block], static_cast<Eigen::Index>(sizes_[block]),
          static_cast<Eigen::Index>(sizes_[block + 1])};
}

void BlockTridiagonal::add_diagonal(std::size_t block, const Eigen::MatrixXd& values) {
  diagonal(block) += values;
}

void BlockTridiagonal::add_upper(std::size_t block, const Eigen::MatrixXd& values) {
  upper(block) += values;
}

void BlockTridiagonal::add_scaled(const BlockTridiagonal& other, double factor) {
  for (std::size_t i = 0; i < diagonal_values_.size(); ++i)
    diagonal_values_[i] += factor * other.diagonal_values_[i];
  for (std::size_t i = 0; i < upper_values_.size(); ++i) upper_values_[i] += factor * other.upper_values_[i];
}

void BlockTridiagonal::hold(std::size_t block, std::size_t row) {
  const auto r = static_cast<Eigen::Index>(row);
  // The column is cleared with the row, so that the matrix stays symmetric and positive definite. The caller
  // sets the right side of a held coordinate to its value.
  Block own = diagonal(block);
  own.row(r).setZero();
  own.col(r).setZero();
  own(r, r) = 1;
  if (block + 1 < blocks()) upper(block).row(r).setZero();
  if (block > 0) upper(block - 1).col(r).setZero();
}

namespace {

// y = A x, y -= A x and y -= A^T x, A row-major.
void multiply(const double* A, std::size_t n, const double* x, double* y) {
  for (std::size_t i = 0; i < n; ++i, A += n) {
    double sum = 0;
    for (std::size_t k = 0; k < n; ++k) sum += A[k] * x[k];
    y[i] = sum;
  }
}

void subtract(const double* A, std::size_t rows, std::size_t columns, const double* x, double* y) {
  for (std::size_t i = 0; i < rows; ++i, A += columns) {
    double sum = 0;
    for (std::size_t k = 0; k < columns; ++k) sum += A[k] * x[k];
    y[i] -= sum;
  }
}

void subtract_transposed(const double* A, std::size_t rows, std::size_t columns, const double* x, double* y) {
  for (std::size_t i = 0; i < rows; ++i, A += columns)
    for (std::size_t k = 0; k < columns; ++k) y[k] -= A[k] * x[i];
}

}  // namespace

void BlockTridiagonal::subtract_product(std::span<const double> x, std::span<double> y) const {
  for (std::size_t j = 0; j < blocks(); ++j) {
    const double* xj = x.data() + first_[j];
    double* yj = y.data() + first_[j];
    const std::size_t n = sizes_[j];
    subtract(diagonal_values_.data() + diagonal_begin_[j], n, n, xj, yj);
    if (j + 1 == blocks()) break;
    const double* block = upper_values_.data() + upper_begin_[j];
    subtract(block, n, sizes_[j + 1], xj + n, yj);
    subtract_transposed(block, n, sizes_[j + 1], xj, yj + n);
  }
}

BlockTridiagonalFactor::BlockTridiagonalFactor(BlockTridiagonal matrix) : inverse_(std::move(matrix)) {
  for (std::size_t j = 0; j < inverse_.blocks(); ++j) {
    auto D = inverse_.diagonal(j);
    const Eigen::LLT<Eigen::MatrixXd> factor{Eigen::MatrixXd(D)};
    if (factor.info() != Eigen::Success)
      throw std::logic_error("block " + std::to_string(j) + " of the soil columns is not positive definite");
    D = factor.solve(Eigen::MatrixXd::Identity(D.rows(), D.cols()));
    if (j + 1 == inverse_.blocks()) break;
    auto upper = inverse_.upper(j);
    const Eigen::MatrixXd coupling = upper;
    upper = D * coupling;
    inverse_.diagonal(j + 1) -= coupling.transpose() * upper;
  }
}

// Forward: b_j -= (D_j-1^-1 A_j-1,j)^T b_j-1; backward: x_j = D_j^-1 b_j - D_j^-1 A_j,j+1 x_j+1.
void BlockTridiagonalFactor::solve(std::span<double> right_side, std::span<double> x) const {
  const BlockTridiagonal& f = inverse_;
  for (std::size_t j = 0; j + 1 < f.blocks(); ++j) {
    double* bj = right_side.data() + f.first_[j];
    subtract_transposed(f.upper_values_.data() + f.upper_begin_[j], f.sizes_[j], f.sizes_[j + 1], bj,
                        bj + f.sizes_[j]);
  }
  for (std::size_t j = f.blocks(); j-- > 0;) {
    const std::size_t n = f.sizes_[j];
    double* xj = x.data() + f.first_[j];
    multiply(f.diagonal_values_.data() + f.diagonal_begin_[j], n, right_side.data() + f.first_[j], xj);
    if (j + 1 < f.blocks())
      subtract(f.upper_values_.data() + f.upper_begin_[j], n, f.sizes_[j + 1], xj + n, xj);
  }
}

}  // namespace adit::simplified::column

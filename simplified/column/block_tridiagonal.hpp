// Symmetric block-tridiagonal matrices with blocks of any size, and their factor.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace adit::simplified::column {

// The blocks are stored one after another, row-major, so that a product or a solve passes through memory
// once.
class BlockTridiagonal {
 public:
  BlockTridiagonal() = default;
  explicit BlockTridiagonal(std::span<const std::size_t> block_sizes);

  std::size_t blocks() const { return sizes_.size(); }
  void add_diagonal(std::size_t block, const Eigen::MatrixXd& values);
  // Adds to the block (block, block + 1) above the diagonal; the block below the diagonal is its transpose.
  void add_upper(std::size_t block, const Eigen::MatrixXd& values);
  void add_scaled(const BlockTridiagonal& other, double factor);  // `other` must have the same block sizes
  // Holds a coordinate: the row and the column `row` of the block become those of the identity.
  void hold(std::size_t block, std::size_t row);

  // y -= A x.
  void subtract_product(std::span<const double> x, std::span<double> y) const;

 private:
  friend class BlockTridiagonalFactor;
  using Block = Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;
  Block diagonal(std::size_t block);
  Block upper(std::size_t block);

  std::vector<std::size_t> sizes_, first_;                 // size and first row of each block row
  std::vector<std::size_t> diagonal_begin_, upper_begin_;  // where each block begins in the values
  std::vector<double> diagonal_values_, upper_values_;
};

// A = L D L^T by blocks, for a positive definite A:
//     D_0 = A_00,   D_j = A_jj - A_j,j-1 D_j-1^-1 A_j-1,j.
// The inverses of the small D_j are stored, and the products D_j^-1 A_j,j+1.
class BlockTridiagonalFactor {
 public:
  BlockTridiagonalFactor() = default;
  // std::logic_error with the block where A is not positive definite.
  explicit BlockTridiagonalFactor(BlockTridiagonal matrix);
  // Solves A x = right_side and overwrites right_side.
  void solve(std::span<double> right_side, std::span<double> x) const;

 private:
  BlockTridiagonal inverse_;  // D_j^-1 on the diagonal, D_j^-1 A_j,j+1 above it
};

}  // namespace adit::simplified::column

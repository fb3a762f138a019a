// Symmetric matrices of blocks in which each block row meets only its neighbours.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace adit::simplified::column {

// The blocks lie one after another, row-major, so that a product or a solve is one pass over memory.
class BlockTridiagonal {
 public:
  BlockTridiagonal() = default;
  explicit BlockTridiagonal(std::span<const std::size_t> block_sizes);

  std::size_t blocks() const { return sizes_.size(); }
  void add_diagonal(std::size_t block, const Eigen::MatrixXd& values);
  // Block (block, block + 1); its transpose below the diagonal is understood.
  void add_upper(std::size_t block, const Eigen::MatrixXd& values);
  void add_scaled(const BlockTridiagonal& other, double factor);  // of the same block sizes
  // The block's row and column `row` become those of the identity: this coordinate is held.
  void hold(std::size_t block, std::size_t row);

  // y -= A x.
  void subtract_product(std::span<const double> x, std::span<double> y) const;

 private:
  friend class BlockTridiagonalFactor;
  using Block = Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;
  Block diagonal(std::size_t block);
  Block upper(std::size_t block);

  std::vector<std::size_t> sizes_, first_;                 // of each block row: size, first row
  std::vector<std::size_t> diagonal_begin_, upper_begin_;  // of each block, into the values
  std::vector<double> diagonal_values_, upper_values_;
};

// A = L D L^T by blocks, for a positive definite A:
//     D_0 = A_00,   D_j = A_jj - A_j,j-1 D_j-1^-1 A_j-1,j.
// The small D_j are kept inverted, beside D_j^-1 A_j,j+1.
class BlockTridiagonalFactor {
 public:
  BlockTridiagonalFactor() = default;
  explicit BlockTridiagonalFactor(BlockTridiagonal matrix);
  // A x = right_side, which is overwritten.
  void solve(std::span<double> right_side, std::span<double> x) const;

 private:
  BlockTridiagonal inverse_;  // D_j^-1 on the diagonal, D_j^-1 A_j,j+1 above it
};

}  // namespace adit::simplified::column

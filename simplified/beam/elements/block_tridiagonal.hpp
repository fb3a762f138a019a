// Symmetric block-tridiagonal matrices with 5×5 blocks, one block row for each node, and their Cholesky
// factor. Elements and joints connect each node with the next only, so every matrix of the model has this
// form.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

namespace adit::simplified::beam {

inline constexpr int kDofs =
    5;  // of a node: u_x, u_y, u_z, section rotation sideways, section rotation upward

using Block = Eigen::Matrix<double, kDofs, kDofs, Eigen::RowMajor>;

struct BlockTridiagonal {
  std::vector<Block> diagonal;  // by node
  std::vector<Block> lower;     // by link: row of node i + 1, column of node i

  explicit BlockTridiagonal(std::size_t nodes = 0);
  std::size_t nodes() const { return diagonal.size(); }
  void add_scaled(const BlockTridiagonal& other, double factor);
  void multiply(std::span<const double> x, std::span<double> y) const;  // y = A x
};

// A = L Lᵀ with a block-bidiagonal L: S_i = D_i − W_{i−1} W_{i−1}ᵀ = C_i C_iᵀ, W_i = B_i C_i⁻ᵀ. The cost
// grows with the number of nodes.
class BlockCholesky {
 public:
  // Factors the block rows from `first` on; those before it must not have changed since the last call.
  // Returns the degree of freedom (5·node + dof) whose pivot is not positive, if any.
  std::optional<std::size_t> factor(const BlockTridiagonal& matrix, std::size_t first = 0);
  void solve(std::span<double> x) const;  // in place

 private:
  std::vector<Block> pivots_, lower_;  // C_i, with the inverse of its diagonal on the diagonal; W_i
};

}  // namespace adit::simplified::beam

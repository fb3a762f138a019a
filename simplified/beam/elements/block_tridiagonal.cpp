#include "simplified/beam/elements/block_tridiagonal.hpp"

#include <cmath>

namespace adit::simplified::beam {
namespace {

// A pivot that is smaller than this relative to the diagonal of the matrix is a rounding error: the motion
// has no stiffness.
constexpr double kSmallestPivot = 1e-14;

// S = C Cᵀ in place (lower triangle), with the inverse of the diagonal of C. Returns the first column whose
// pivot is not positive, or −1.
int cholesky(Block& s, const Block& unreduced) {
  for (int j = 0; j < kDofs; ++j) {
    double pivot = s(j, j);
    for (int k = 0; k < j; ++k) pivot -= s(j, k) * s(j, k);
    if (!(pivot > kSmallestPivot * unreduced(j, j))) return j;
    // The inverse is stored because a solve then multiplies where it would divide.
    s(j, j) = 1 / std::sqrt(pivot);
    for (int i = j + 1; i < kDofs; ++i) {
      double sum = s(i, j);
      for (int k = 0; k < j; ++k) sum -= s(i, k) * s(j, k);
      s(i, j) = sum * s(j, j);
    }
  }
  return -1;
}

// W Cᵀ = B, column by column: W_j = (B_j − Σ_{k<j} W_k C_jk) / C_jj.
void divide(const Block& b, const Block& c, Block& w) {
  for (int j = 0; j < kDofs; ++j)
    for (int i = 0; i < kDofs; ++i) {
      double sum = b(i, j);
      for (int k = 0; k < j; ++k) sum -= w(i, k) * c(j, k);
      w(i, j) = sum * c(j, j);
    }
}

void subtract_square(Block& s, const Block& w) {
  for (int i = 0; i < kDofs; ++i)
    for (int j = 0; j <= i; ++j) {
      double sum = 0;
      for (int k = 0; k < kDofs; ++k) sum += w(i, k) * w(j, k);
      s(i, j) -= sum;
    }
}

}  // namespace

BlockTridiagonal::BlockTridiagonal(std::size_t nodes)
    : diagonal(nodes, Block::Zero()), lower(nodes > 0 ? nodes - 1 : 0, Block::Zero()) {}

void BlockTridiagonal::add_scaled(const BlockTridiagonal& other, double factor) {
  for (std::size_t i = 0; i < diagonal.size(); ++i) diagonal[i] += factor * other.diagonal[i];
  for (std::size_t i = 0; i < lower.size(); ++i) lower[i] += factor * other.lower[i];
}

void BlockTridiagonal::multiply(std::span<const double> x, std::span<double> y) const {
  using Vector = Eigen::Matrix<double, kDofs, 1>;
  const std::size_t n = nodes();
  const auto in = [&](std::size_t i) { return Eigen::Map<const Vector>(x.data() + kDofs * i); };
  for (std::size_t i = 0; i < n; ++i) {
    Vector sum = diagonal[i] * in(i);
    if (i > 0) sum.noalias() += lower[i - 1] * in(i - 1);
    if (i + 1 < n) sum.noalias() += lower[i].transpose() * in(i + 1);
    Eigen::Map<Vector>(y.data() + kDofs * i) = sum;
  }
}

std::optional<std::size_t> BlockCholesky::factor(const BlockTridiagonal& matrix, std::size_t first) {
  const std::size_t n = matrix.nodes();
  pivots_.resize(n);
  lower_.resize(n > 0 ? n - 1 : 0);
  for (std::size_t i = first; i < n; ++i) {
    pivots_[i] = matrix.diagonal[i];
    if (i > 0) subtract_square(pivots_[i], lower_[i - 1]);
    if (const int failed = cholesky(pivots_[i], matrix.diagonal[i]); failed >= 0) return kDofs * i + failed;
    if (i + 1 < n) divide(matrix.lower[i], pivots_[i], lower_[i]);
  }
  return std::nullopt;
}

void BlockCholesky::solve(std::span<double> x) const {
  using Vector = Eigen::Matrix<double, kDofs, 1>;
  const std::size_t n = pivots_.size();
  Vector previous = Vector::Zero();
  for (std::size_t i = 0; i < n; ++i) {  // L y = x
    Vector y = Eigen::Map<const Vector>(x.data() + kDofs * i);
    const Block& c = pivots_[i];
    if (i > 0) y.noalias() -= lower_[i - 1] * previous;
    for (int k = 0; k < kDofs; ++k) {
      y[k] *= c(k, k);
      for (int r = k + 1; r < kDofs; ++r) y[r] -= c(r, k) * y[k];
    }
    Eigen::Map<Vector>(x.data() + kDofs * i) = previous = y;
  }
  for (std::size_t i = n; i-- > 0;) {  // Lᵀ x = y
    Vector y = Eigen::Map<const Vector>(x.data() + kDofs * i);
    const Block& c = pivots_[i];
    if (i + 1 < n) y.noalias() -= lower_[i].transpose() * previous;
    for (int k = kDofs - 1; k >= 0; --k) {
      y[k] *= c(k, k);
      for (int r = 0; r < k; ++r) y[r] -= c(k, r) * y[k];
    }
    Eigen::Map<Vector>(x.data() + kDofs * i) = previous = y;
  }
}

}  // namespace adit::simplified::beam

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "simplified/beam/elements/block_tridiagonal.hpp"

namespace adit::simplified::beam::block_tridiagonal_test {
namespace {

BlockTridiagonal positive_matrix(std::size_t nodes) {
  BlockTridiagonal matrix(nodes);
  std::srand(3);
  for (auto& block : matrix.lower) block = Block::Random();
  for (auto& block : matrix.diagonal) {
    const Block random = Block::Random();
    block = random + random.transpose() + 15 * Block::Identity();
  }
  return matrix;
}

Eigen::MatrixXd dense(const BlockTridiagonal& matrix) {
  const Eigen::Index n = kDofs * matrix.nodes();
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t i = 0; i < matrix.nodes(); ++i) {
    a.block<kDofs, kDofs>(kDofs * i, kDofs * i) = matrix.diagonal[i];
    if (i == 0) continue;
    a.block<kDofs, kDofs>(kDofs * i, kDofs * (i - 1)) = matrix.lower[i - 1];
    a.block<kDofs, kDofs>(kDofs * (i - 1), kDofs * i) = matrix.lower[i - 1].transpose();
  }
  return a;
}

TEST(BlockTridiagonal, MultipliesAndSolvesLikeTheDenseMatrix) {
  const BlockTridiagonal matrix = positive_matrix(7);
  const Eigen::VectorXd x = Eigen::VectorXd::Random(35);
  Eigen::VectorXd product(35);
  matrix.multiply({x.data(), 35}, {product.data(), 35});
  EXPECT_LT((product - dense(matrix) * x).norm(), 1e-13 * product.norm());
  BlockCholesky factor;
  ASSERT_FALSE(factor.factor(matrix));
  factor.solve({product.data(), 35});
  EXPECT_LT((product - x).norm(), 1e-13 * x.norm());
}

// Factoring again from the first changed row gives the same bits as factoring everything again.
TEST(BlockCholesky, FactorsFromTheFirstChangedRow) {
  BlockTridiagonal matrix = positive_matrix(7);
  BlockCholesky partial, whole;
  partial.factor(matrix);
  matrix.diagonal[4](2, 2) += 3;
  partial.factor(matrix, 4);
  whole.factor(matrix);
  std::vector<double> a(35, 1.0), b(35, 1.0);
  partial.solve(a);
  whole.solve(b);
  EXPECT_EQ(a, b);
}

TEST(BlockCholesky, NamesTheDegreeOfFreedomWithoutStiffness) {
  BlockTridiagonal matrix = positive_matrix(4);
  matrix.diagonal[2].row(3).setZero();
  matrix.diagonal[2].col(3).setZero();
  matrix.lower[1].row(3).setZero();
  matrix.lower[2].col(3).setZero();
  EXPECT_EQ(BlockCholesky().factor(matrix), std::optional<std::size_t>(2 * kDofs + 3));
}

}  // namespace
}  // namespace adit::simplified::beam::block_tridiagonal_test

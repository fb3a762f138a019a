// Requirement: the factor solves what it factored, says what it holds in memory, and takes no matrix that is
// not positive definite.
#include "protocol/kernels/symmetric_factor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace adit::protocol::symmetric_factor_test {
namespace {

Eigen::SparseMatrix<double> lower_of(const Eigen::MatrixXd& matrix) {
  return Eigen::MatrixXd(matrix.triangularView<Eigen::Lower>()).sparseView();
}

TEST(SymmetricFactor, SolvesForOneSideAndForTwo) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-1, 1);
  const int n = 12;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n) * 4;
  for (int i = 0; i < n; ++i)
    for (const int j : {(i + 1) % n, (i + 5) % n}) matrix(i, j) = matrix(j, i) = share(random);
  const SymmetricFactor factor(lower_of(matrix));
  ASSERT_EQ(factor.size(), n);
  const Eigen::MatrixXd given = Eigen::MatrixXd::Random(n, 2), expected = matrix.llt().solve(given);
  Eigen::Array<double, 2, Eigen::Dynamic> two(2, n);
  Eigen::Array<double, 1, Eigen::Dynamic> one(1, n);
  for (int i = 0; i < n; ++i) {
    two.col(factor.place(i)) = given.row(i).transpose();
    one(factor.place(i)) = given(i, 1);
  }
  factor.solve(two);
  factor.solve(one);
  for (int i = 0; i < n; ++i) {
    EXPECT_NEAR(two(0, factor.place(i)), expected(i, 0), 1e-14);
    EXPECT_NEAR(two(1, factor.place(i)), expected(i, 1), 1e-14);
    EXPECT_NEAR(one(factor.place(i)), expected(i, 1), 1e-14);
  }
}

// A value and a row's number for each entry of L, a column's begin, a pivot and a place for each row.
TEST(SymmetricFactor, TellsItsMemory) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  EXPECT_EQ(SymmetricFactor(lower_of(matrix)).bytes(), 3u * (8 + 2 * 4));
  matrix(2, 0) = matrix(0, 2) = 0.5;
  EXPECT_EQ(SymmetricFactor(lower_of(matrix)).bytes(), 12u + 3u * (8 + 2 * 4));
}

TEST(SymmetricFactor, RefusesWhatIsNotPositiveDefinite) {
  EXPECT_THROW(SymmetricFactor(lower_of(Eigen::MatrixXd::Constant(1, 1, -1))), std::logic_error);
  EXPECT_THROW(SymmetricFactor(lower_of(Eigen::Vector2d(1, -1).asDiagonal())), std::logic_error);
  EXPECT_EQ(SymmetricFactor(Eigen::SparseMatrix<double>(0, 0)).size(), 0);
}

}  // namespace
}  // namespace adit::protocol::symmetric_factor_test

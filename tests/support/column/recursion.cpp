#include "tests/support/column/recursion.hpp"

#include <unsupported/Eigen/MatrixFunctions>

namespace adit::simplified::column::test {

// With the load added to the unknowns, y' = A y + b a and a' = (a_end - a_start)/dt, a step is one matrix
// exponential.
Recursion piecewise_linear(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, double dt) {
  const Eigen::Index n = A.rows();
  Eigen::MatrixXd with_load = Eigen::MatrixXd::Zero(n + 2, n + 2);
  with_load.topLeftCorner(n, n) = A * dt;
  with_load.block(0, n, n, 1) = b * dt;
  with_load(n, n + 1) = 1;
  const Eigen::MatrixXd step = with_load.exp();
  // The last two columns answer to the load at the start and to its rise over the step (Van Loan 1978). The
  // load at the end is the start plus the rise, hence the difference.
  const Eigen::VectorXd from_level = step.block(0, n, n, 1), from_rise = step.block(0, n + 1, n, 1);
  return {step.topLeftCorner(n, n), from_level - from_rise, from_rise};
}

}  // namespace adit::simplified::column::test

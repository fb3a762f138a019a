// Exact steps of a linear system y' = A y + b a(t) with a(t) linear between its samples.
#pragma once

#include <Eigen/Core>

namespace adit::simplified::column::test {

// y(t + dt) = transition * y(t) + from_start * a(t) + from_end * a(t + dt).
struct Recursion {
  Eigen::MatrixXd transition;
  Eigen::VectorXd from_start, from_end;
};

Recursion piecewise_linear(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, double dt);

}  // namespace adit::simplified::column::test

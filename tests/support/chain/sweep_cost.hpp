// The cost of a step, beside that of a general sparse solver on the same equations.
#pragma once

#include <cstddef>

#include "simplified/chain/model/chain.hpp"

namespace adit::simplified::chain::test {

// A bored tunnel of n rings of 1.5 m (concrete of 6.8/5.84 m), flexible ring joints, in ground that varies
// along it; ends free.
Chain rings(std::size_t n);

struct SweepCost {
  std::size_t bodies;
  long steps;
  double sweep_seconds;        // Riccati sweep: the steps alone
  double direct_seconds;       // Eigen's sparse LDL^T, factored once, the same steps
  double relative_difference;  // of the last displacements, against the largest
  double sweep_ns() const { return 1e9 * sweep_seconds / (static_cast<double>(bodies) * steps); }
  double direct_ns() const { return 1e9 * direct_seconds / (static_cast<double>(bodies) * steps); }
};

// Shakes rings(bodies) by a travelling wave for `steps` steps of 5 ms with both solvers. The steps alone are
// timed, without factoring and filling in ground motions, in processor time of the one core.
SweepCost sweep_cost(std::size_t bodies, long steps);

}  // namespace adit::simplified::chain::test

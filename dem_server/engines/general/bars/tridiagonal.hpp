// Systems of equations of chains and rings: each unknown meets its two neighbours only.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace adit::dem {

// Symmetric, positive definite: diagonal[k] x[k] + off[k-1] x[k-1] + off[k] x[k+1] = right[k]. As many `off`
// as unknowns close a ring, one less leave a chain (Thomas; Sherman and Morrison).
class Tridiagonal {
 public:
  std::vector<double> diagonal, off;

  // Replaces `right` by the solution.
  void solve(std::span<double> right) const {
    const std::size_t n = diagonal.size();
    if (off.size() < n || n < 3) return solve_chain(diagonal, right);
    const double corner = off[n - 1], gamma = -diagonal[0];
    std::vector<double> changed = diagonal, column(n, 0.0);
    changed[0] -= gamma;
    changed[n - 1] -= corner * corner / gamma;
    column[0] = gamma;
    column[n - 1] = corner;
    solve_chain(changed, right);
    solve_chain(changed, column);
    const double share =
        (right[0] + right[n - 1] * corner / gamma) / (1 + column[0] + column[n - 1] * corner / gamma);
    for (std::size_t k = 0; k < n; ++k) right[k] -= share * column[k];
  }

 private:
  void solve_chain(const std::vector<double>& main, std::span<double> right) const {
    const std::size_t n = main.size();
    std::vector<double> ratio(n, 0.0);
    double pivot = main[0];
    right[0] /= pivot;
    for (std::size_t k = 1; k < n; ++k) {
      ratio[k] = off[k - 1] / pivot;
      pivot = main[k] - off[k - 1] * ratio[k];
      right[k] = (right[k] - off[k - 1] * right[k - 1]) / pivot;
    }
    for (std::size_t k = n - 1; k-- > 0;) right[k] -= ratio[k + 1] * right[k + 1];
  }
};

}  // namespace adit::dem

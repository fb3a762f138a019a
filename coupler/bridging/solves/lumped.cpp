#include "coupler/bridging/solves/lumped.hpp"

#include <cmath>

namespace adit::coupler {

LumpedSolve::LumpedSolve(const Interpolation& coarse, std::span<const double> fine_masses)
    : inverse_row_sums_(fine_masses.size()) {
  // The row sums of |N| M⁻¹ |N|ᵀ, found by applying the matrix to a vector of ones instead of forming it.
  std::vector<double> seen(coarse.own_points());  // |N|ᵀ 1
  for (std::size_t k = 0; k < coarse.coupling_points(); ++k)
    for (std::size_t e = 0; e < coarse.columns(k).size(); ++e)
      seen[coarse.columns(k)[e]] += std::abs(coarse.values(k)[e]);
  for (std::size_t i = 0; i < fine_masses.size(); ++i) {
    const std::size_t k = i / 2, direction = i % 2;
    double row_sum = 1.0 / fine_masses[i];
    for (std::size_t e = 0; e < coarse.columns(k).size(); ++e) {
      const std::size_t j = coarse.columns(k)[e];
      row_sum += std::abs(coarse.values(k)[e]) * coarse.inverse_masses()[2 * j + direction] * seen[j];
    }
    inverse_row_sums_[i] = 1.0 / row_sum;
  }
}

void LumpedSolve::solve(std::span<const double> coarse_velocities, std::span<const double> fine_velocities,
                        std::span<double> multipliers) {
  for (std::size_t i = 0; i < multipliers.size(); ++i)
    multipliers[i] = inverse_row_sums_[i] * (coarse_velocities[i] - fine_velocities[i]);
}

}  // namespace adit::coupler

#include "coupler/bridging/lumped.hpp"

namespace adit::coupler {

LumpedSolve::LumpedSolve(const Interpolation& continuum, const Interpolation& particles)
    : inverse_row_sums_(2 * continuum.coupling_points()) {
  // Row sums of N M⁻¹ Nᵀ without forming it: apply it to a vector of ones.
  const std::vector<double> ones(2 * continuum.coupling_points(), 1.0);
  std::vector<double> row_sums(ones.size());
  for (const Interpolation* side : {&continuum, &particles}) {
    std::vector<double> own(2 * side->own_points());
    std::vector<double> part(ones.size());
    side->gather(ones, own);
    side->divide_by_mass(own);
    side->interpolate(own, part);
    for (std::size_t i = 0; i < part.size(); ++i) row_sums[i] += part[i];
  }
  for (std::size_t i = 0; i < row_sums.size(); ++i) inverse_row_sums_[i] = 1.0 / row_sums[i];
}

void LumpedSolve::solve(std::span<const double> gap, std::span<double> multipliers) {
  for (std::size_t i = 0; i < gap.size(); ++i) multipliers[i] = inverse_row_sums_[i] * gap[i];
}

}  // namespace adit::coupler

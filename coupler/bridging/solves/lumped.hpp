// The row-sum solve: A_L λ = g with A_L the diagonal of the row sums of |N| M⁻¹ |N|ᵀ + m⁻¹.
//
// These sums are not smaller than the sums of the magnitudes in the rows of A = N M⁻¹ Nᵀ + m⁻¹, and equal to
// them if N has no negative entry. Each row of A_L − A is therefore diagonally dominant, and the matrix is
// positive semidefinite. Hence the change of kinetic energy in a correction,
//     −λᵀ g + ½ λᵀ A λ = −½ λᵀ A_L λ − ½ λᵀ (A_L − A) λ,
// is never positive. Velocities are not quite continuous: waves that are short compared with a zone are
// damped, and the more so the more often a correction is made, that is the smaller the time step is.
#pragma once

#include <vector>

#include "coupler/bridging/solves/multipliers.hpp"

namespace adit::coupler {

class LumpedSolve : public MultiplierSolve {
 public:
  LumpedSolve(const Interpolation& coarse, std::span<const double> fine_masses);
  void solve(std::span<const double> coarse_velocities, std::span<const double> fine_velocities,
             std::span<double> multipliers) override;

 private:
  std::vector<double> inverse_row_sums_;  // interleaved like the multipliers
};

}  // namespace adit::coupler

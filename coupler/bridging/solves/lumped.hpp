// The row-sum solve: A_L λ = g with A_L the diagonal of the row sums of |N| M⁻¹ |N|ᵀ + m⁻¹.
//
// These are no less than the sums of the magnitudes in the rows of A = N M⁻¹ Nᵀ + m⁻¹, and the same where N
// has no negative entry. So A_L − A is positive semidefinite (each row is diagonally dominant), and the
// change of kinetic energy in a correction, −λᵀ g + ½ λᵀ A λ = −½ λᵀ A_L λ − ½ λᵀ (A_L − A) λ, is never
// positive. Velocities are not quite continuous: what is short against a zone is damped, the more the
// smaller the time step is.
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

// Exact continuity: A λ = g with A = N_C M⁻¹ N_Cᵀ + m⁻¹.
//
// A couples all particles of neighbouring zones: it is nearly full in blocks, though it is only a diagonal
// (m⁻¹, N_P being the identity) plus a term of the grid's rank. So λ is found on the grid's own points.
// With y = M⁻¹ N_Cᵀ λ, the correction of the grid's velocities, the two equations
//     M y = N_Cᵀ λ,   λ = m (g − N_C y)
// give   (M + N_Cᵀ m N_C) y = N_Cᵀ m g,
// a mass matrix: the grid's own, and that of the particles as the grid sees them. It is sparse, symmetric,
// positive definite and never worse conditioned than these masses; it is factored once, by LDLᵀ. A grid
// velocity that is prescribed (1/M = 0) has y = 0 and drops out.
#pragma once

#include <Eigen/Sparse>
#include <array>
#include <vector>

#include "coupler/bridging/multipliers.hpp"

namespace adit::coupler {

class ConsistentSolve : public MultiplierSolve {
 public:
  ConsistentSolve(const Interpolation& continuum, const Interpolation& particles);
  void solve(std::span<const double> gap, std::span<double> multipliers) override;

 private:
  struct Direction {                // x or y
    std::vector<std::size_t> free;  // the grid points that are free in this direction
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor;
    Eigen::VectorXd right_side, correction;
  };
  void factor(int direction);

  Interpolation interpolation_;          // N_C
  std::vector<double> particle_masses_;  // m, interleaved like the multipliers
  std::array<Direction, 2> directions_;
  std::vector<double> on_grid_;  // one pair for each grid point
};

}  // namespace adit::coupler

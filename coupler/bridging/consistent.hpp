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
  struct Component {                                             // the x or the y direction
    Eigen::SparseMatrix<double, Eigen::RowMajor> interpolation;  // N_C restricted to free grid points
    Eigen::VectorXd particle_masses;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor;
    Eigen::VectorXd gap, weighted_gap, right_side, grid_correction, multipliers;
  };
  std::array<Component, 2> components_;
};

}  // namespace adit::coupler

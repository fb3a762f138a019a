// Exact continuity: A λ = g with the gap g = N V* − v* and A = N M⁻¹ Nᵀ + m⁻¹.
//
// A couples all fine points of neighbouring zones, so its blocks are nearly full. Yet it is a diagonal plus a
// term whose rank is only the number of coarse points. Therefore λ is found on the points of the coarse side.
// With y = M⁻¹ Nᵀ λ, the correction of the coarse velocities, the two equations
//     M y = Nᵀ λ,   λ = m (g − N y)
// give   (M + Nᵀ m N) y = Nᵀ m g.
// A prescribed coarse velocity (1/M = 0) has y = 0 and is left out of the system.
#pragma once

#include <vector>

#include "coupler/bridging/solves/coarse_mass.hpp"
#include "coupler/bridging/solves/multipliers.hpp"

namespace adit::coupler {

class ConsistentSolve : public MultiplierSolve {
 public:
  ConsistentSolve(const Interpolation& coarse, std::span<const double> fine_masses);
  void solve(std::span<const double> coarse_velocities, std::span<const double> fine_velocities,
             std::span<double> multipliers) override;
  SolveCost cost() const override { return masses_.cost(); }

 private:
  Interpolation coarse_;
  std::vector<double> fine_masses_;  // m
  CoarseMass masses_;                // M + Nᵀ m N
  std::vector<double> correction_;   // y
  std::vector<double> gap_;
};

}  // namespace adit::coupler

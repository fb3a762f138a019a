// The mass matrix of both sides on the points of the coarse one: D + Nᵀ m N, in x and in y, with a diagonal D
// and the masses m of the fine points. It is symmetric, positive definite, and sparse, because it couples
// only points of the same and of neighbouring zones. Its condition is no worse than that of the masses. Parts
// of the interface that share no point are separate blocks.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "coupler/bridging/interpolation.hpp"
#include "coupler/bridging/solves/multipliers.hpp"
#include "protocol/kernels/symmetric_factor.hpp"

namespace adit::coupler {

// The masses M of the coarse points, interleaved; infinite where a motion is prescribed.
std::vector<double> masses_of(const Interpolation& coarse);

class CoarseMass {
 public:
  // `fine_masses` has a pair (x, y) for each coupling point, `diagonal` one for each coarse point. An
  // infinite entry of the diagonal stands for a motion that no force changes; its solution is 0.
  CoarseMass(const Interpolation& coarse, std::span<const double> fine_masses,
             std::span<const double> diagonal);

  void solve(std::span<double> own);  // own := (D + Nᵀ m N)⁻¹ own, interleaved; allocates nothing
  const SolveCost& cost() const { return cost_; }

 private:
  // One factor serves both directions if their matrices are equal, which they are unless a motion is
  // prescribed in one direction only.
  template <int Sides>
  struct Directions {
    protocol::SymmetricFactor factor;
    std::vector<std::size_t> own;                   // for each place of the factor, its value in `own`
    std::vector<std::size_t> fixed;                 // the values in `own` whose solution is 0
    Eigen::Array<double, Sides, Eigen::Dynamic> x;  // right-hand sides, whose memory is reused
    void solve(std::span<double> own_values);
  };
  template <int Sides>
  Directions<Sides> factor(const Interpolation& coarse, std::span<const double> fine_masses,
                           std::span<const double> diagonal, int direction);

  std::optional<Directions<2>> both_;
  std::vector<Directions<1>> each_;
  SolveCost cost_;
};

}  // namespace adit::coupler

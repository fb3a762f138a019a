// The masses of both sides as the points of the coarse one see them: D + Nᵀ m N, in x and in y, with a
// diagonal D and the masses m of the fine points. The matrix is sparse (points of neighbouring zones),
// symmetric, positive definite and no worse conditioned than the masses. Parts of the interface that share
// no point are its blocks.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "coupler/bridging/interpolation.hpp"
#include "coupler/bridging/solves/cost.hpp"
#include "coupler/bridging/solves/symmetric_factor.hpp"

namespace adit::coupler {

// M, interleaved; infinite where the motion is prescribed.
std::vector<double> masses_of(const Interpolation& coarse);

class CoarseMass {
 public:
  // Interleaved: `fine_masses` one pair for each coupling point, `diagonal` one for each coarse point. An
  // infinite entry of the diagonal is a motion that no force changes: its solution is 0.
  CoarseMass(const Interpolation& coarse, std::span<const double> fine_masses,
             std::span<const double> diagonal);

  void solve(std::span<double> own);  // own := (D + Nᵀ m N)⁻¹ own, interleaved; allocates nothing
  const SolveCost& cost() const { return cost_; }

 private:
  // One factor serves both directions where their matrices are the same, as they mostly are.
  template <int Sides>
  struct Directions {
    SymmetricFactor factor;
    std::vector<std::size_t> own;                   // value of `own` that belongs to a place of the factor
    std::vector<std::size_t> fixed;                 // values that are 0
    Eigen::Array<double, Sides, Eigen::Dynamic> x;  // reused
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

// The multipliers of the velocity constraint N V = v at the coupling points (bridging-domain method; Xiao and
// Belytschko 2004). Two sides share an overlap. The fine side has a point of its own, with mass m and
// velocity v, at every coupling point. The velocities V of the points of the coarse side, with masses M, are
// interpolated there by N. From the predicted velocities a solve finds the impulses λ [N s] that correct both
// sides:
//     V −= M⁻¹ Nᵀ λ,   v += m⁻¹ λ.
// Rows of N sum to 1, so both sides together keep their linear momentum, whatever λ is.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "coupler/bridging/interpolation.hpp"

namespace adit::scene {
enum Solve : int;
}

namespace adit::coupler {

// The cost of a multiplier solve: the time for setting it up, and its memory.
struct SolveCost {
  double factor_seconds = 0;     // assembly and factorization
  std::size_t factor_bytes = 0;  // memory of the factors
  std::size_t unknowns = 0;      // unknowns of all systems that are solved in a step
};

class MultiplierSolve {
 public:
  virtual ~MultiplierSolve() = default;
  // Finds the multipliers from the predicted velocities of both sides at the coupling points [m/s], N V and
  // v. All have one pair (x, y) for each coupling point. Allocates nothing.
  virtual void solve(std::span<const double> coarse_velocities, std::span<const double> fine_velocities,
                     std::span<double> multipliers) = 0;
  virtual SolveCost cost() const { return {}; }
};

// `fine_masses`: m, one pair (x, y) for each coupling point [kg], infinite where a motion is prescribed.
// `decay`: for the solve `split`, the share of the fine motion that each coupling point loses in a step
// (split.hpp); empty otherwise.
// Throws protocol::UserError if the motion of a fine point is prescribed, or if the points of the coarse side
// lie closer together than those of the fine side.
std::unique_ptr<MultiplierSolve> make_multiplier_solve(scene::Solve kind, const Interpolation& coarse,
                                                       std::span<const double> fine_masses,
                                                       std::span<const double> decay);

}  // namespace adit::coupler

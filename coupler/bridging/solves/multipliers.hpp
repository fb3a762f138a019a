// The multipliers of the velocity constraint V = v at the coupling points (bridging-domain method; Xiao and
// Belytschko 2004). Of the two sides that share an overlap, the fine one has a point of its own, of mass m,
// at every coupling point; the velocities V of the coarse side's points, of masses M, are interpolated there
// by N. From the predicted velocities a solve finds the impulses λ [N s] with which both are corrected:
//     V −= M⁻¹ Nᵀ λ,   v += m⁻¹ λ.
// Rows of N sum to 1, so whatever λ is, both sides together keep their linear momentum.
#pragma once

#include <memory>
#include <span>

#include "coupler/bridging/interpolation.hpp"
#include "coupler/bridging/solves/cost.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::coupler {

class MultiplierSolve {
 public:
  virtual ~MultiplierSolve() = default;
  // Predicted velocities of both sides at the coupling points [m/s] (N V and v), and the multipliers: one
  // pair (x, y) for each coupling point. Allocates nothing.
  virtual void solve(std::span<const double> coarse_velocities, std::span<const double> fine_velocities,
                     std::span<double> multipliers) = 0;
  virtual SolveCost cost() const { return {}; }
};

// `fine_masses`: m, one pair (x, y) for each coupling point [kg], infinite where a motion is prescribed.
// `decay`: for the solve `split`, the share of the fine motion that each coupling point loses in a step
// (decay.hpp); empty otherwise.
// Throws protocol::UserError for a fine point with a prescribed motion, and for a coarse side that is finer
// than the fine one.
std::unique_ptr<MultiplierSolve> make_multiplier_solve(scene::Solve kind, const Interpolation& coarse,
                                                       std::span<const double> fine_masses,
                                                       std::span<const double> decay);

}  // namespace adit::coupler

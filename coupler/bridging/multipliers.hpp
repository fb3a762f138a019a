// The multipliers of the velocity constraint g = N_C v_C − N_P v_P = 0 (bridging-domain method; Xiao and
// Belytschko 2004). Given the gap g of the predicted velocities, a solve returns the impulses λ [N s] with
// which the velocities are corrected:
//     v_C −= M⁻¹ N_Cᵀ λ,   v_P += m⁻¹ N_Pᵀ λ.
// Rows of N sum to 1, so whatever λ is, both sides together keep their linear momentum.
#pragma once

#include <memory>
#include <span>

#include "coupler/bridging/interpolation.hpp"
#include "protocol/scene.pb.h"

namespace adit::coupler {

class MultiplierSolve {
 public:
  virtual ~MultiplierSolve() = default;
  // gap and multipliers: one pair (x, y) for each coupling point.
  virtual void solve(std::span<const double> gap, std::span<double> multipliers) = 0;
};

// N_P must be a selection (each coupling point is a particle): anything else, and a particle in the overlap
// whose motion is prescribed, is refused with a protocol::UserError.
std::unique_ptr<MultiplierSolve> make_multiplier_solve(scene::Solve kind, const Interpolation& continuum,
                                                       const Interpolation& particles);

}  // namespace adit::coupler

// The solve `split`: continuity of the motions that the coarse side can represent, decay of all others.
//
// Let G = Nᵀ m N be the fine masses, distributed to the coarse points, and Q = N G⁻¹ Nᵀ m the projection on
// the motions that the coarse side can represent. Q is self-adjoint in the scalar product xᵀ m y of the
// kinetic energy, and so is 1 − Q, the projection on the remaining, fine motion. A step has two parts.
//
// 1. The fine motion decays: v₁ = v* − S v*, S = (1 − Q) D (1 − Q), where the diagonal D holds the shares
// lost at
//    the coupling points. S is self-adjoint, and 0 ≤ S ≤ 1 because 0 ≤ D ≤ 1, so the kinetic energy never
//    rises. Q S = 0, so motions that the coarse side can represent do not change. Neither does the linear
//    momentum, because N represents constants.
// 2. The coarse part of the motion becomes continuous by v = v₁ + N μ, V = V* − M⁻¹ G μ: the impulses m N μ
// act on
//    both sides. From Nᵀ m (N V − v) = 0 follows, with b = Nᵀ m g and the gap g = N V* − v*,
//        (G + G M⁻¹ G) μ = b,   μ = z − y,   G z = b,   (M + G) y = b,
//    where y is the correction of the consistent solve. By the first equation the work of these impulses is
//    −½ bᵀ μ ≤ 0. Afterwards Q v = N V exactly.
// The first part is an impulse, too, −m S v*. It does not act on the coarse side, because Nᵀ m S = 0. So one
// vector of multipliers makes both parts, and momentum is kept exactly:
//     λ = m (N μ − S v*).
// With c = G⁻¹ Nᵀ m v*, w = D (v* − N c), and z now the solution of G z = b + Nᵀ m w:  λ = m (N (z − y) − w).
//
// Where the overlap cuts zones, a coarse point may have hardly any fine point nearby, and a motion of the
// coarse side none. G is then singular or nearly so, and G + ε diag G replaces it in all equations. The
// proofs still hold. With E = ε diag G, the eigenvalues of Q fall below 1 but stay in [0, 1). The work of the
// impulses, −bᵀμ + ½ μᵀ(G + G M⁻¹ G) μ, stays negative, because G M⁻¹ G ≤ 2 (G + E) M⁻¹ (G + E) + 2 E M⁻¹ E,
// and E M⁻¹ E ≤ E unless a fine mass is 1/ε times a coarse one. ε only has to exceed the rounding errors of
// G; the discontinuity and the Q S that remain are of the order of ε.
#pragma once

#include <span>
#include <vector>

#include "coupler/bridging/solves/coarse_mass.hpp"
#include "coupler/bridging/solves/multipliers.hpp"

namespace adit::coupler {

// The rate at which the fine motion decays.
//
// Damping that grows gradually reflects least, so the rate grows with the third power of the distance into
// the overlap. Its largest value was chosen by measurement (tests/verification/bridging/wave_test.cpp): a
// wave far too short for the grid is absorbed before it returns from the end of the fine side, while a wave
// with λ = 5h loses about 1 %. Both depend only on rate · width / wave speed, not on h, the size of the
// particles or the time step.
//
// Rate where the fine side ends [1/s], for an overlap of this width [m] and compression waves of this speed
// in the fine side [m/s].
double default_decay_rate(double wave_speed, double width);

// The share of the fine motion that each coupling point loses in a step: 1 − exp(−rate · across³ · dt).
// `across` is the position of a coupling point in the overlap: 0 where the coarse side ends, 1 where the fine
// side ends.
std::vector<double> decay_per_step(std::span<const double> across, double rate, double dt);

class SplitSolve : public MultiplierSolve {
 public:
  // `decay`: D, one share in [0, 1] for each coupling point.
  SplitSolve(const Interpolation& coarse, std::span<const double> fine_masses, std::span<const double> decay);
  void solve(std::span<const double> coarse_velocities, std::span<const double> fine_velocities,
             std::span<double> multipliers) override;
  SolveCost cost() const override;

 private:
  void gather_momentum(std::span<const double> velocities, std::span<double> own);  // own = Nᵀ m velocities

  Interpolation coarse_;
  std::vector<double> fine_masses_;                   // m
  std::vector<double> decay_;                         // D
  CoarseMass fine_only_;                              // G
  CoarseMass both_;                                   // M + G
  std::vector<double> carried_, shift_, correction_;  // on the coarse points: c, z, y
  std::vector<double> decayed_;                       // w
  std::vector<double> momentum_;                      // m times a velocity, at the coupling points
};

}  // namespace adit::coupler

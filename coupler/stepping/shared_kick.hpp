// Substeps: the particles take m steps dt while the continuum takes one, DT = m dt.
//
// Between two of its own kicks a grid point only has mass: its velocity X follows the impulses at every step
// of the particles, with no force and no motion. Once in DT, at the particles' kick k = n m + m/2 (so m is
// even), in the middle of its time from t_n to t_{n+1}, it makes its whole step: half a kick by the force
// F_n, the motion DT Y, half a kick by F_{n+1}. These two kicks are solved together with the particles' kick
// k: shared. The grid's participant runs as it does without substeps, one exchange each DT; it need not know
// m.
//
// With C the inverse operator of the solve (A⁻¹, or what stands for it), B = N M⁻¹ Nᵀ, w = N X, q_n = N DT
// F_n/M, v* the particles' velocities after a kick by their own forces, and Λ the impulse that the grid has
// not yet got:
//   any kick      λ = C (w − v*);  w −= B λ;  Λ += λ;  v = v* + λ/m
//   shared kick   λ₁ = ½ C (w + q_n − v*);  Λ + λ₁ goes to the grid, whose V* for t_{n+3/2} comes back, p = N
//   V*
//                 y = w + ½ q_n − B λ₁  (= N V(n+½));   q_{n+1} = p − y
//                 λ₂ = ½ C (w + q_{n+1} − v*);  w = y + ½ q_{n+1} − B λ₂;  Λ = λ₂;  v = v* + (λ₁ + λ₂)/m
//   start         w = 0, q_0 = 2 p, y = −p: the grid's first kick is half a one, as is the particles'
//
// Momentum is exact, since every λ acts on both. Energy: with P = M⁻¹ − M⁻¹NᵀCNM⁻¹, which is 0 ≤ P ≤ M⁻¹
// because C is symmetric and C ≤ A⁻¹, the mean of X before and after the shared kick is Y + ¼ DT P (F_{n+1} −
// F_n), so the work of the two half kicks is ½ DT (F_n + F_{n+1})·Y + ⅛ DT² [F_{n+1}·P F_{n+1} − F_n·P F_n].
// The first term is the change of the grid's strain energy, as in leap-frog, the second telescopes. With the
// consistent solve the multipliers do no work, and for linear models
//   H = ½ vᵀmv + ½ u_k·k u_{k+1} + ½ XᵀMX + ½ UᵀKU − ⅛ DT² FᵀPF
// is kept exactly. It is positive while each participant is below its own critical step, for every m and
// every contrast: there are no resonances, which other explicit schemes of several time steps have (Grote,
// Michel and Sauter 2021). The lumped and the split solve only take energy away. Xiao and Belytschko (2004)
// and Gravouil and Combescure (2001) are the schemes that it was measured against.
//
// So the ledger closes at every step. The grid's participant tells E = ½ Y·M V* + ½ UᵀKU, with Y before its
// last kick by F_n and V* after it. Since X = Y + ½ DT F_n/M − M⁻¹NᵀΛ, its part of H is, in terms of the
// coupling points,
//   E − ½ Λ·(y + ½ q_n + w) + ⅛ q_n·C q_n,
// and in the middle of the particles' kick, of which their energies are, ½ λ·w more (λ·w at the start, where
// the kick is half a one). Loads, prescribed motions and dashpots, of which the participants tell, change
// nothing of it.
//
// The particles' velocities carry a sawtooth of period DT, which radiates where m asin(dt/dt_critical) ≥ π;
// displacements of both sides agree to O(DT²).
#pragma once

#include <cstdint>
#include <vector>

#include "coupler/exchange/round_trip.hpp"
#include "coupler/participants/set_up.hpp"
#include "coupler/stepping/ledger.hpp"
#include "coupler/stepping/stepper.hpp"

namespace adit::coupler {

class SharedKick : public TimeScheme {
 public:
  SharedKick(Model& model, CondensedRegions& regions, Ledger& ledger, StepCost& cost);

  // To the time of the grid's step n: the grid is at its step n, the particles at step n m.
  // Energies are those of that time.
  void step(std::uint64_t n, Wanted wanted) override;
  // The grid's prediction is made to be X + ½ DT F_n/M, as if X were Y + ½ DT F_n/M with nothing left to
  // give.
  void take_over(const GridMotion& motion) override;
  void exchange(state::Archive& archive) override {
    archive("kick_w", std::span(w_));
    archive("kick_q", std::span(q_));
    archive("kick_y", std::span(y_));
    archive("kick_v", std::span(v_));
    archive("kick_p", std::span(p_));
    archive("kick_target", std::span(target_));
    archive("kick_lambda", std::span(lambda_));
    archive("kick_lambda_1", std::span(lambda_1_));
    archive("kick_total", std::span(total_));
  }

 private:
  void start(Wanted wanted);
  void kick(std::uint64_t k, Wanted wanted);
  void shared_kick(std::uint64_t k, std::uint64_t n, Wanted wanted);

  void ask(Role role, std::uint64_t step, double dt, Wanted wanted, void (SharedKick::*meanwhile)());
  void end_kick(const std::vector<double>& multipliers);  // of the particles
  void book();
  void book_grid();
  // `share_of_kick`: how much of the last kick of the particles is still to come in their energies.
  void take_energies(double share_of_kick);

  Model& model_;
  CondensedRegions& regions_;
  Ledger& ledger_;
  StepCost& cost_;
  wire::Advance request_;
  // One pair for each coupling point, named as above.
  std::vector<double> w_, q_, y_, v_, p_, target_, lambda_, lambda_1_, total_;
  bool unbooked_ = false;  // neither the grid nor the ledger has the last kick's multipliers
};

}  // namespace adit::coupler

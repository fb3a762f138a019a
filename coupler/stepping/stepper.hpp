// One coupled time step: predict on every side, solve for the multipliers, correct.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "coupler/sides/set_up.hpp"
#include "coupler/stepping/exchange.hpp"
#include "coupler/stepping/ledger.hpp"
#include "coupler/stepping/shared_kick.hpp"
#include "coupler/stepping/wanted.hpp"

namespace adit::coupler {

class Stepper {
 public:
  explicit Stepper(Model& model);

  // To step n = 0, 1, 2 … One round trip: the correction of step n − 1 and the prediction of step n ride in
  // the same message. With substeps, particles take several in turn (shared_kick.hpp).
  void step(std::uint64_t n, Wanted wanted);

  // The same in statics (wire.proto, Advance), without substeps: all velocities are stopped first where
  // `stop` says so. Afterwards step(0, …) starts from the state at rest.
  void relax(std::uint64_t n, bool stop, std::uint32_t stage);

  // The state at the step reached, of every side in turn.
  std::vector<wire::Snapshot> snapshots() { return take_snapshots(model_.sides); }

  // Complete up to the last step that wanted energies.
  const Ledger& ledger() const { return ledger_; }
  const StepCost& cost() const { return cost_; }

 private:
  void exchange();
  void book(bool with_energies);

  Model& model_;
  Ledger ledger_;
  StepCost cost_;
  std::unique_ptr<SharedKick> shared_kick_;  // with substeps
  wire::Advance request_;
  std::vector<Side*> order_;                         // in which they are asked
  std::vector<double> coarse_, fine_, multipliers_;  // one pair for each coupling point
  bool unbooked_ = false;                            // the last step is not yet in the ledger
};

}  // namespace adit::coupler

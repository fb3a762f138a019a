// One coupled time step: predict on every side, solve for the multipliers, correct.
#pragma once

#include <cstdint>
#include <vector>

#include "coupler/ledger.hpp"
#include "coupler/set_up.hpp"

namespace adit::coupler {

// What a step shows beside the participants' own answers.
struct Wanted {
  bool energies = false;
  bool histories = false;
};

class Stepper {
 public:
  explicit Stepper(Model& model);

  // To step n = 0, 1, 2 … One round trip: the correction of step n − 1 and the prediction of step n ride in
  // the same message.
  void step(std::uint64_t n, Wanted wanted);

  // The state at the step reached, of every side in turn.
  std::vector<wire::Snapshot> snapshots();

  const Ledger& ledger() const { return ledger_; }
  double wait_s() const { return wait_s_; }    // between the last send and the last answer
  double solve_s() const { return solve_s_; }  // multipliers and ledger

 private:
  void post_advance(Side& side, std::uint64_t n, Wanted wanted);
  void correct();

  Model& model_;
  Ledger ledger_;
  std::vector<double> gap_, multipliers_;
  bool impulses_pending_ = false;  // computed, but not yet sent
  double wait_s_ = 0, solve_s_ = 0;
};

}  // namespace adit::coupler

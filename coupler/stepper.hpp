// One coupled time step: predict on every side, solve for the multipliers, correct.
#pragma once

#include <cstdint>
#include <optional>
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

  // The same in statics (wire.proto, Advance): all velocities are stopped first where `stop` says so.
  // Afterwards step(0, …) starts from the state at rest.
  void relax(std::uint64_t n, bool stop);

  // The state at the step reached, of every side in turn.
  std::vector<wire::Snapshot> snapshots();

  // Complete up to the last step that wanted energies.
  const Ledger& ledger() const { return ledger_; }
  double wait_s() const {
    return wait_s_;
  }  // from the first send to the last answer, the ledger's work included
  double solve_s() const {
    return solve_s_;
  }  // for the multipliers, and the ledger where it could not be hidden

 private:
  void exchange();
  void post_advance(Side& side);
  void solve();
  void book(bool with_energies);

  Model& model_;
  Ledger ledger_;
  wire::Advance request_;                       // the part that is the same for all sides
  std::vector<Side*> order_;                    // in which they are asked
  bool impulses_pending_ = false;               // computed, but not yet sent
  std::optional<std::uint64_t> unbooked_step_;  // computed, but not yet in the ledger
  double wait_s_ = 0, solve_s_ = 0;
};

}  // namespace adit::coupler

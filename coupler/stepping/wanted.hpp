#pragma once

namespace adit::coupler {

// What a step shows beside the participants' own answers.
struct Wanted {
  bool energies = false;
  bool histories = false;
  bool peaks = false;  // the step enters the peaks over time
};

// Seconds of a run so far.
struct StepCost {
  double wait = 0;   // from the first send to the last answer, the ledger's work included
  double solve = 0;  // for the multipliers
};

}  // namespace adit::coupler

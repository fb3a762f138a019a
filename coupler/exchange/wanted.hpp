#pragma once

namespace adit::coupler {

// What a step shows beside the participants' own answers.
struct Wanted {
  bool energies = false;
  bool histories = false;
  bool peaks = false;  // the step enters the peaks over time
};

}  // namespace adit::coupler

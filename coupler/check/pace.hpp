// How fast a model steps, found by stepping it for about a second.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "coupler/output/schedule.hpp"
#include "coupler/stepping/stepper.hpp"

namespace adit::coupler {

struct Pace {
  double set_up = 0;                  // [s]
  double step = 0;                    // of time [s]
  std::vector<double> computed = {};  // by each participant in it [s]
  double relaxing = 0;                // step of statics [s]; 0: the scene has none
  bool waiting = false;               // particles wait in these steps (stepping/condensed_regions.hpp)
  std::string unstable;  // why the first steps failed; then the model cannot be asked for anything more

  bool stable() const { return unstable.empty(); }
};

// Relaxes the model where the scene has statics, then steps it in time as a run does, with the energies,
// histories and peaks that the schedule wants; half a second each, or a second of the latter alone. Nothing
// is recorded.
Pace measure_pace(const Model& model, const Schedule& schedule, Stepper& stepper);

}  // namespace adit::coupler

// All that a run must keep to go on bitwise as if it had never stopped, besides what its participants keep.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "coupler/checkpoint/checkpoints.hpp"
#include "coupler/output/motion_outputs.hpp"
#include "coupler/output/recorder.hpp"
#include "coupler/participants/set_up.hpp"
#include "coupler/stepping/statics.hpp"
#include "coupler/stepping/stepper.hpp"
#include "coupler/watch.hpp"

namespace adit::coupler {

struct RunState {
  Model& model;
  Stepper& stepper;
  Recorder& recorder;
  MotionOutputs& motions;
  Watch& watch;
  Statics* statics = nullptr;
  std::uint64_t next_step = 0;              // of time
  double stepping_s = 0;                    // wall-clock time in steps
  std::vector<std::uint64_t> resumed = {};  // steps of time from which the run has gone on

  // "coupler", the coupled steps; "outputs", how far the results are.
  std::map<std::string, state::Parts> save();

  // Sets this state and those of the participants. Another run, which begins from the state at rest, has
  // outputs of its own. Throws protocol::UserError for a state that the model or a participant cannot go on
  // from.
  void restore(const Checkpoint& checkpoint, bool same_run);
};

}  // namespace adit::coupler

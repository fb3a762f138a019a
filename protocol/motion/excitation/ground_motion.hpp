// The ground motion of a scene (ground_motion.proto).
#pragma once

#include <string>
#include <vector>

#include "protocol/messages/ground_motion.pb.h"
#include "protocol/motion/motion.hpp"
#include "protocol/motion/processing/processing.hpp"
#include "protocol/motion/synthesis/pulses.hpp"

namespace adit::motion {

// What a run uses of a motion.
struct UsedMotion {
  // From `from` to `until`, or to the end of the motion: as long as the run, with rest after `until`, or
  // longer.
  Motion motion;
  double duration = 0;  // of the run [s]
  // Pulses and synthetic motions are straight lines between their values, records are samples of what was.
  Interpolation interpolation = Interpolation::kLinear;
  // Where the ground lies when the run begins, in the displacement of the whole motion [m].
  double place = 0;
  std::vector<std::string> notes = {};  // for the user, where the motion is cut inside shaking

  // What acts during the run, with straight lines between the values.
  Motion acting() const { return acting(motion); }
  // The same of a motion that was made of this one, such as that of another station.
  Motion acting(const Motion& other) const;
};

// The motion after the processing that the scene asks for. A record or a pulse is made, tapered, filtered,
// its baseline corrected, and scaled as a whole; then the run's part is taken, so that the duration of the
// run changes nothing of what comes before its end. A synthetic motion lasts until `until`, or to the end of
// the run, but at least as long as its periods need.
//
// Records are sent with the scene (attached_files.hpp). They are processed at their own step and have the
// sampling's step afterwards. Throws UserError below `path`, for example if a record ends before the run does
// and `until` does not say so.
UsedMotion ground_motion(const scene::GroundMotion& scene, const std::string& path, const Sampling& sampling);

// The same at a step for solvers whose own step is much shorter: the step of a record, 1/200 of the period of
// a pulse, 5 ms for a synthetic motion. Straight lines between such values change the amplitude of a pulse by
// less than 1e-4.
UsedMotion ground_motion(const scene::GroundMotion& scene, const std::string& path, double duration);

}  // namespace adit::motion

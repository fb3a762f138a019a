// The ground motion of a scene (ground_motion.proto).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "protocol/messages/ground_motion.pb.h"
#include "protocol/motion/motion.hpp"
#include "protocol/motion/processing/processing.hpp"
#include "protocol/motion/synthesis/pulses.hpp"

namespace adit::motion {

// What a run uses of a motion.
struct UsedMotion {
  // From `from` to `until`, or to the end of the motion, whatever the duration of the run. The ground keeps
  // its last velocity afterwards, which is zero after `until` and after a correction of the baseline.
  Motion motion;
  double duration = 0;  // of the run [s]
  // Pulses and synthetic motions are straight lines between their values, records are samples of what was.
  Interpolation interpolation = Interpolation::kLinear;
  // Where the ground lies when the run begins, in the displacement of the whole motion [m].
  double place = 0;
  double peak = 0;                      // the largest acceleration that acts during the run [m/s^2]
  std::vector<std::string> notes = {};  // for the user, where the motion is cut inside shaking

  // What acts during the run, with straight lines between the values, and for as long afterwards: the last
  // step of a run may end a step later, and looks half a step ahead.
  Motion acting() const { return acting(motion); }
  // The same of a motion that was made of this one, such as that of another station.
  Motion acting(const Motion& other) const;
};

// The motion after the processing that the scene asks for. It is made, tapered, filtered, its baseline
// corrected, and scaled as a whole: a record from its first value to its last, a pulse until it has died away
// and the filters have answered, a synthetic motion up to `until`, or for 20 s. Then the run's part is taken.
// So the duration of the run changes nothing of what comes before its end. `peak` is that of the straight
// lines which drive the solver.
//
// Records are sent with the scene (attached_files.hpp). They are processed at their own step and have the
// sampling's step afterwards. Throws UserError below `path`, for example if a record ends before the run does
// and `until` does not say so.
UsedMotion ground_motion(const scene::GroundMotion& scene, const std::string& path, const Sampling& sampling);

// The same at a step for solvers whose own step is much shorter: the step of a record, 1/200 of the period of
// a pulse, 5 ms for a synthetic motion. Straight lines between such values change the amplitude of a pulse by
// less than 1e-4.
UsedMotion ground_motion(const scene::GroundMotion& scene, const std::string& path, double duration);

// Where the largest acceleration that acts is not the stated `peak`, if one is stated.
std::optional<std::string> note_on_peak(const scene::GroundMotion& scene, const UsedMotion& used);

}  // namespace adit::motion

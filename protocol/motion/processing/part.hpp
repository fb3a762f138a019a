// The part of a motion that a run uses.
//
// A run begins at rest, but the ground moves at most times of a record. The velocity v of the whole motion is
// therefore multiplied by a window w, half a cosine that rises from 0 to 1 within a second (or a quarter of a
// shorter part):
//   (w v)' = w a + w' v.
// After it, acceleration and velocity are those of the whole motion, and the displacement counts from the
// begin. A window on the acceleration alone would leave a constant velocity behind; one on the displacement
// would add accelerations of up to a fifth of the peak where a record has long waves. Before an end that lies
// inside the motion the window falls likewise, so that the ground comes to rest.
#pragma once

#include "protocol/motion/motion.hpp"

namespace adit::motion {

// The part from `from` to `until` [s], both to the nearest step; `until` may lie after the end. Refuses a
// part outside the motion, and one of fewer than 17 values that is cut inside the motion.
Motion part(const Motion& whole, double from, double until);

// What the displacement of the part lacks, once the window has risen, to that of the whole motion [m]: where
// the ground lies when the part begins.
double place_at_begin(const Motion& whole, double from, double until);

// The most by which the window raises |acceleration| where the part begins and ends [m/s^2].
double added_by_window(const Motion& whole, double from, double until);

}  // namespace adit::motion

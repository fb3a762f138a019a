// Preparation of a motion: cut, taper, scale, baseline, another time step. Each takes a motion and returns
// another; none changes its argument.
#pragma once

#include <cstddef>

#include "protocol/motion/motion.hpp"

namespace adit::motion {

// The times from `begin` to `end` [s], both rounded to the nearest step. A motion that ends before `end` is
// refused.
Motion cut(const Motion& motion, double begin, double end);

// Zeros before and after, each as long as stated [s], rounded to the nearest step.
Motion padded(const Motion& motion, double before, double after);

// Half a cosine from zero to one over the first `begin` seconds, and from one to zero over the last `end`.
Motion tapered(const Motion& motion, double begin, double end);

Motion scaled(const Motion& motion, double factor);

// Scaled so that the largest absolute acceleration is `peak` [m/s^2].
Motion scaled_to_peak(const Motion& motion, double peak);

// Velocity and displacement at the end made zero by adding s (1 - s) (c0 + c1 s) with s = t / duration to
// the acceleration. The correction is zero at both ends, so a motion that begins and ends at rest still
// does. Needs at least four values.
Motion baseline_corrected(const Motion& motion);

// The motion at steps of `dt` up to its last time.
//   kLinear:       on the straight lines between the values: no overshoot; lowers what is near the Nyquist
//                  frequency and lets what is above the new one fold back.
//   kBandLimited:  through a low pass at the lower of both Nyquist frequencies (a Kaiser-windowed sinc of 32
//                  zero crossings a side): frequencies below 0.9 of it are kept to 1e-4, those above 1.1
//                  removed. A motion that begins or ends with a jump rings there; taper it before.
enum class Interpolation { kLinear, kBandLimited };
Motion resampled(const Motion& motion, double dt, Interpolation interpolation);

// The motion `delay` seconds later, with `count` values: band-limited between the steps, so that every
// frequency below 0.9 of Nyquist is delayed without loss; exact where the delay is a multiple of the step.
// The motion is zero before its begin and after its end.
Motion delayed(const Motion& motion, double delay, std::size_t count);

}  // namespace adit::motion

// Processing of motions: cutting, padding, tapering, scaling, baseline correction, resampling. Each function
// returns a new motion.
#pragma once

#include <cstddef>

#include "protocol/motion/motion.hpp"

namespace adit::motion {

// The part of the motion from `begin` to `end` [s], both rounded to the nearest step. A motion that ends
// before `end` is refused.
Motion cut(const Motion& motion, double begin, double end);

// The motion with zeros for `before` and `after` [s] added, both rounded to the nearest step.
Motion padded(const Motion& motion, double before, double after);

// The motion multiplied by half a cosine wave that rises from zero to one over the first `begin` seconds, and
// by one that falls to zero over the last `end` seconds.
Motion tapered(const Motion& motion, double begin, double end);

Motion scaled(const Motion& motion, double factor);

// The motion scaled so that its largest absolute acceleration is `peak` [m/s^2].
Motion scaled_to_peak(const Motion& motion, double peak);
// The same for the peak of a curve through its values, such as the refined motion.
Motion scaled_to_peak(const Motion& motion, double peak, const Motion& curve);

// The motion up to its first value not before `end` [s], or all of it.
Motion beginning(const Motion& motion, double end);

// The same, with zeros after the end of a shorter motion.
Motion lasting(const Motion& motion, double end);

// Gives the motion this velocity [m/s] and displacement [m] at its end by adding s (1 - s) (c0 + c1 s),
// s = t / duration, to the acceleration. The correction vanishes at both ends, so that a motion without
// acceleration there keeps that. Needs at least four values.
Motion ended_with(const Motion& motion, double velocity, double displacement);

// The same with both zero: the ground ends at rest, at the place where it began.
Motion baseline_corrected(const Motion& motion);

// The motion at steps of `dt` up to its last time.
//   kLinear:       values on the straight lines between the given ones. It never overshoots, but lowers
//                  amplitudes near the Nyquist frequency and folds back frequencies above the new one.
//   kBandLimited:  a low pass at the lower of both Nyquist frequencies (a Kaiser-windowed sinc with 32 zero
//                  crossings on each side). It keeps frequencies below 0.9 of that one to 1e-4 and removes
//                  those above 1.1 of it. A motion that begins or ends with a jump rings there; taper it
//                  before.
enum class Interpolation { kLinear, kBandLimited };
Motion resampled(const Motion& motion, double dt, Interpolation interpolation);

// The motion with `parts` steps in each of its own, band-limited between its values, which it keeps. It ends
// with the velocity and displacement of `motion`: what the kernel spreads beyond the ends is made up for.
// Straight lines between the new values lower an amplitude of frequency f by 1 - sinc^2(f dt / parts); with 8
// parts that is 1.1 % at 0.9 of the Nyquist frequency, where straight lines between the given values take 59
// %.
Motion refined(const Motion& motion, int parts);

// The motion, delayed by `delay` [s], with `count` values. It is band-limited between the steps, so that
// every frequency below 0.9 of the Nyquist frequency is delayed without loss; a delay by whole steps is
// exact. The motion is zero before its begin and after its end.
Motion delayed(const Motion& motion, double delay, std::size_t count);

}  // namespace adit::motion

// Pulses given by formulas, sampled at steps of `dt` from 0 to the last step not after `duration` [s].
// Frequencies [Hz] must lie above zero and below the Nyquist frequency; `peak` is an acceleration [m/s^2].
#pragma once

#include "protocol/motion/motion.hpp"

namespace adit::motion {

struct Sampling {
  double dt;        // [s]
  double duration;  // [s]
};

// peak (1 - 2 x^2) exp(-x^2), x = pi frequency (t - centre). The displacement is the Gaussian
// -peak exp(-x^2) / (2 pi^2 frequency^2), so that the ground returns to its place.
Motion ricker(double peak, double frequency, double centre, const Sampling& sampling);

// peak sin(2 pi frequency t) up to the time `end`, then zero.
Motion sine(double peak, double frequency, double end, const Sampling& sampling);

// peak exp(-(2 pi frequency (t - centre) / width)^2) cos(2 pi frequency (t - centre) + phase); `width` is
// the number of radians of the carrier over which the envelope falls by a factor e; `phase` [rad].
Motion gabor(double peak, double frequency, double width, double phase, double centre,
             const Sampling& sampling);

}  // namespace adit::motion

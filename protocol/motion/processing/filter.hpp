// Butterworth filters. At the corner frequency the amplitude is multiplied by 1/sqrt(2) (-3 dB), for every
// order and phase.
#pragma once

#include "protocol/motion/motion.hpp"

namespace adit::motion {

// kZero:   multiplies the Fourier spectrum by 1/sqrt(1 + (f/f_c)^2n) for a low pass, with f_c/f for a high
// pass.
//          No frequency is delayed, but the result begins before the motion does. The motion is padded with
//          at least as many zeros as it has values.
// kCausal: second-order sections by the bilinear transform that keeps the corner; begins at rest.
enum class Phase { kZero, kCausal };

// `corner` [Hz], above 0 and below the Nyquist frequency 1 / (2 dt); `order` from 1 to 20.
Motion low_pass(const Motion& motion, double corner, int order, Phase phase);
Motion high_pass(const Motion& motion, double corner, int order, Phase phase);

}  // namespace adit::motion

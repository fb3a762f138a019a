// Butterworth filters. Amplitude at the corner: 1/sqrt(2), that is -3 dB, whatever the order and phase.
#pragma once

#include "protocol/motion/motion.hpp"

namespace adit::motion {

// kZero:   multiplies the Fourier spectrum by 1/sqrt(1 + (f/f_c)^2n) (low pass), (f_c/f in high pass): no
//          frequency is delayed, but the result begins before its cause. The motion is padded with as many
//          zeros as it has values, at least.
// kCausal: second-order sections, bilinear transform with the corner kept; begins at rest.
enum class Phase { kZero, kCausal };

// `corner` [Hz], above 0 and below the Nyquist frequency 1 / (2 dt); `order` from 1 to 20.
Motion low_pass(const Motion& motion, double corner, int order, Phase phase);
Motion high_pass(const Motion& motion, double corner, int order, Phase phase);

// The high pass at `low` followed by the low pass at `high`, each of the order.
Motion band_pass(const Motion& motion, double low, double high, int order, Phase phase);

}  // namespace adit::motion

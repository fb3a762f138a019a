// How much one motion holds of each frequency, as a multiple of another: the amplification of the ground
// between.
#pragma once

#include <span>
#include <vector>

#include "protocol/motion/motion.hpp"

namespace adit::motion {

// Fourier amplitude, squared, averaged around each of `frequencies` [Hz, above 0] with the window of Konno
// and Ohmachi (1998), as wide on every part of a logarithmic axis:
//   W(f, fc) = [sin(b lg(f/fc)) / (b lg(f/fc))]^4,   b = 40: half its height at a factor of 1.06.
// The roots of these means [m/s]. The motion is lengthened with zeros, so that the lines stand closer than
// the window is wide. Frequencies beyond the Nyquist frequency have no value (NaN).
std::vector<double> smoothed_amplitude(const Motion& motion, std::span<const double> frequencies);

// Ratio of the smoothed amplitudes of two motions that begin together and have the same step and length;
// infinite or not a number where the first holds nothing.
std::vector<double> transfer_function(const Motion& from, const Motion& to,
                                      std::span<const double> frequencies);

}  // namespace adit::motion

// Amplification of the ground between two motions: the ratio of their smoothed Fourier amplitudes.
#pragma once

#include <span>
#include <vector>

#include "protocol/motion/motion.hpp"

namespace adit::motion {

// Root [m/s] of the mean squared Fourier amplitude around each of `frequencies` [Hz, above 0]. The mean is
// weighted by the window of Konno and Ohmachi (1998), whose width is constant on a logarithmic axis:
//   W(f, fc) = [sin(b lg(f/fc)) / (b lg(f/fc))]^4,   b = 40, which is 1/2 at f = 1.06 fc.
// The motion is padded with zeros, so that the spectral lines lie closer together than the window is wide.
// Frequencies above the Nyquist frequency have no value (NaN).
std::vector<double> smoothed_amplitude(const Motion& motion, std::span<const double> frequencies);

// Ratio of the smoothed amplitudes of two motions that begin together and have the same step and length;
// infinite or NaN where the amplitude of `from` is zero.
std::vector<double> transfer_function(const Motion& from, const Motion& to,
                                      std::span<const double> frequencies);

}  // namespace adit::motion

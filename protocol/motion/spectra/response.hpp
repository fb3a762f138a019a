// The response of a damped oscillator to a motion, and the spectrum of its peaks.
#pragma once

#include <span>
#include <vector>

#include "protocol/motion/motion.hpp"

namespace adit::motion {

// Relative displacement [m] and velocity [m/s], and absolute acceleration [m/s^2], at the motion's times:
//   u'' + 2 damping w u' + w^2 u = -a(t), w = 2 pi / period, at rest at time 0.
// Exact for straight lines between the values (Nigam and Jennings 1969). 0 <= damping < 1, period > 0 [s].
struct OscillatorResponse {
  std::vector<double> displacement;
  std::vector<double> velocity;
  std::vector<double> absolute_acceleration;
};
OscillatorResponse oscillator_response(const Motion& motion, double period, double damping);

// Peaks over the motion, one value for each period. A period of 0 means a rigid oscillator, whose
// accelerations are the peak of the motion. Peaks are taken at the motion's times and, for short periods, at
// further times between them, at most period / 40 apart: so they are at most 1 - cos(pi/40) = 0.3 % too low.
struct ResponseSpectrum {
  std::vector<double> period;                 // [s]
  std::vector<double> displacement;           // max |u| [m]
  std::vector<double> velocity;               // max |u'| [m/s]
  std::vector<double> pseudo_acceleration;    // w^2 max |u| [m/s^2]
  std::vector<double> absolute_acceleration;  // max |u'' + a| [m/s^2]
};
ResponseSpectrum response_spectrum(const Motion& motion, std::span<const double> periods, double damping);

// `count` periods from first to last with equal ratios.
std::vector<double> logarithmic_periods(double first, double last, int count);

}  // namespace adit::motion

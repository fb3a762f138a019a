// The measures of a ground motion that engineers quote.
#pragma once

#include <vector>

#include "protocol/motion/motion.hpp"

namespace adit::motion {

// Largest absolute values: PGA [m/s^2], PGV [m/s], PGD [m].
struct Peaks {
  double acceleration;
  double velocity;
  double displacement;
};
// The displacement counts from `place` [m].
Peaks peaks(const Motion& motion, double place = 0);

// Arias intensity [m/s]: pi / (2 g) times the integral of the acceleration squared, exact for the straight
// lines between the values.
double arias_intensity(const Motion& motion);

// The growth of the Arias intensity over the motion's times (Husid's plot), as shares of its final value from
// 0 to 1; all 0 if nothing moves.
std::vector<double> husid(const Motion& motion);

// Time [s] in which the Arias intensity grows from the share `from` to the share `to` of its final value;
// 0.05 and 0.95 give the significant duration of Trifunac and Brady (1975). Shares are linear between the
// motion's times.
double significant_duration(const Motion& motion, double from, double to);

// Cumulative absolute velocity [m/s]: the integral of |acceleration|, exact for straight lines between the
// values.
double cumulative_absolute_velocity(const Motion& motion);

// Amplitude |dt sum a_k exp(-2 pi i f k dt)| [m/s] at `frequency` [Hz] from 0 to the Nyquist frequency. The
// motion is padded with zeros to a power of two, 2 m values, so there are m + 1 frequencies at steps of 1 /
// (2 m dt).
struct FourierSpectrum {
  std::vector<double> frequency;
  std::vector<double> amplitude;
};
FourierSpectrum fourier_spectrum(const Motion& motion);

// The frequency [Hz] below which this share of the motion's Fourier energy lies, the integral of the squared
// amplitude (by Parseval's theorem its Arias intensity); 0 if nothing moves.
double frequency_below(const Motion& motion, double share);

}  // namespace adit::motion

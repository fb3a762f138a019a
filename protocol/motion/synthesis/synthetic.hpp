// Synthetic motions whose response spectrum follows a target spectrum (Gasparini and Vanmarcke 1976, SIMQKE).
#pragma once

#include <cstdint>

#include "protocol/motion/motion.hpp"
#include "protocol/motion/spectra/target_spectrum.hpp"

namespace adit::motion {

// The envelope grows as t^2 up to `rise`, is one up to `decay`, and then falls as exp(-rate (t - decay)).
struct Envelope {
  double rise;   // [s]
  double decay;  // [s]
  double rate;   // [1/s]
};

struct SyntheticRequest {
  TargetSpectrum target;
  double shortest_period;  // [s]; begin of the band in which the target is to be met; at least 4 dt
  double longest_period;   // [s]; end of the band; at most a third of the duration
  double dt;               // [s]
  double duration;         // [s]
  Envelope envelope;
  std::uint64_t seed;  // the same seed gives the same motion
  int iterations = 30;
};

struct SyntheticMotion {
  Motion motion;  // ends at rest, at the place where it began
  // |response / target - 1| over kControlPeriods periods, spread evenly over the band on a logarithmic axis.
  double mean_misfit;
  double max_misfit;
  int iterations;  // number of iterations after which this motion, the best one, was found
};
inline constexpr int kControlPeriods = 100;

// a(t) = envelope(t) sum A_k cos(2 pi f_k t + phi_k) with random phi_k. Each iteration multiplies A_k by
// target / response at the period 1/f_k and corrects the baseline. The motion with the smallest mean misfit
// is returned.
SyntheticMotion synthesize(const SyntheticRequest& request);

}  // namespace adit::motion

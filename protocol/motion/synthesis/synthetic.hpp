// Synthetic motions whose response spectrum follows a target (Gasparini & Vanmarcke 1976, SIMQKE).
#pragma once

#include <cstdint>

#include "protocol/motion/motion.hpp"
#include "protocol/motion/spectra/target_spectrum.hpp"

namespace adit::motion {

// Grows as t^2 up to `rise`, is one up to `decay`, then falls by exp(-rate (t - decay)).
struct Envelope {
  double rise;   // [s]
  double decay;  // [s]
  double rate;   // [1/s]
};

struct SyntheticRequest {
  TargetSpectrum target;
  double shortest_period;  // [s]; the band in which the target is to be met; at least 4 dt
  double longest_period;   // [s]; at most a third of the duration
  double dt;               // [s]
  double duration;         // [s]
  Envelope envelope;
  std::uint64_t seed;  // the same seed gives the same motion
  int iterations = 30;
};

struct SyntheticMotion {
  Motion motion;  // ends at rest and in its place
  // |response / target - 1| over kControlPeriods periods, evenly spread in the logarithm over the band.
  double mean_misfit;
  double max_misfit;
  int iterations;  // after which the motion was the best
};
inline constexpr int kControlPeriods = 100;

// a(t) = envelope(t) sum A_k cos(2 pi f_k t + phi_k), phi_k random. Each iteration multiplies A_k by
// target / response at the period 1/f_k and corrects the baseline; of all motions the one with the
// smallest mean misfit is returned.
SyntheticMotion synthesize(const SyntheticRequest& request);

}  // namespace adit::motion

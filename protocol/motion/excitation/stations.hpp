// Non-uniform excitation: from one motion, every station along a line gets a motion of its own.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "protocol/motion/motion.hpp"

namespace adit::motion {

struct NonUniform {
  // Speed at which the wave travels along the line [m/s]: positive towards larger chainage, negative towards
  // smaller, infinite if it reaches all stations at once.
  double apparent_velocity = std::numeric_limits<double>::infinity();
  // Loss of coherency [s/m] (Luco and Wong 1986): two stations at a distance d have the coherency
  // exp(-(drift w d)^2) at the angular frequency w. Common values are 2e-4 to 3e-4 s/m; 0 means no loss.
  double drift = 0;
  std::uint64_t seed = 0;  // seed of the random numbers in the incoherent part
};

// One motion for each station, in the order of the chainages [m]. All have the step of `motion`, and as many
// values as `motion` plus the steps that the wave needs from the first station to the last. The station that
// the wave reaches first (the first in the list if it reaches all at once) has exactly `motion`. The
// incoherent part at a station depends on the seed and on the distance from that first station, not on other
// stations.
std::vector<Motion> station_motions(const Motion& motion, std::span<const double> chainages,
                                    const NonUniform& excitation);

// exp(-(drift w d)^2), w = 2 pi frequency.
double luco_wong(double drift, double frequency, double distance);

}  // namespace adit::motion

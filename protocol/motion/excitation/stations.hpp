// Non-uniform excitation: one motion at the origin becomes a motion of its own at every station along a line.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "protocol/motion/motion.hpp"

namespace adit::motion {

struct NonUniform {
  // Speed at which the motion runs towards larger chainage [m/s]; negative towards smaller. Infinite: all
  // stations at once.
  double apparent_velocity = std::numeric_limits<double>::infinity();
  // Loss of coherency (Luco & Wong 1986): two stations at a distance d keep exp(-(drift w d)^2) of their
  // coherency at the angular frequency w. Commonly 2e-4 to 3e-4 s/m; 0: none lost.
  double drift = 0;
  std::uint64_t seed = 0;  // of the incoherent part
};

// One motion a station, in the order of the chainages [m], all with the same step and number of values: those
// of `motion`, and as many more as the wave needs from the first station to the last. The station that the
// wave meets first (the first of the list where it meets all at once) has exactly `motion`. The incoherent
// part of a place depends on the seed and on its distance from that station, not on the other stations.
std::vector<Motion> station_motions(const Motion& motion, std::span<const double> chainages,
                                    const NonUniform& excitation);

// exp(-(drift w d)^2), w = 2 pi frequency.
double luco_wong(double drift, double frequency, double distance);

}  // namespace adit::motion

// Loss of coherency between stations that the wave reaches at the same time.
#pragma once

#include <span>
#include <vector>

#include "protocol/motion/excitation/stations.hpp"

namespace adit::motion {

// One motion for each distance, all as long as `motion`; any two have the coherency of `luco_wong` between
// them. The station at distances[reference] has `motion` itself.
std::vector<Motion> incoherent_motions(const Motion& motion, std::span<const double> distances,
                                       std::size_t reference, double drift, std::uint64_t seed);

}  // namespace adit::motion

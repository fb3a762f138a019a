// Loss of coherency between stations that the wave meets at the same time.
#pragma once

#include <span>
#include <vector>

#include "protocol/motion/excitation/stations.hpp"

namespace adit::motion {

// One motion a distance, all of the length of `motion`, any two with the coherency of `luco_wong` between
// them; distances[reference] keeps `motion` itself.
std::vector<Motion> incoherent_motions(const Motion& motion, std::span<const double> distances,
                                       std::size_t reference, double drift, std::uint64_t seed);

}  // namespace adit::motion

// How near the ground came to its strength, for the summary of the run.
#pragma once

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/output/peaks.hpp"
#include "protocol/messages/wire.pb.h"

namespace adit::fdm {

// largest_demand over zones and time (materials/demand.hpp), with …_time_s and the zone's centroid, …_x_m and
// …_y_m; of equal ones that of the first zone. None where no material states a strength.
void add_largest_demand(const Grid& grid, const Peaks& peaks, wire::Bye& bye);

}  // namespace adit::fdm

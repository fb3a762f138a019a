// The stress of the ground before anything acts: in each zone that of its centre. A column whose vertical
// stress grows by its weight is then in equilibrium to rounding, because the grid's masses are lumped.
#pragma once

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/zones/zone_set.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

void set_initial_stress(const scene::Stress& stress, const Grid& grid, ZoneSet& zones);

}  // namespace adit::fdm

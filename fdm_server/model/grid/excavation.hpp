// The zones that the scene takes away. Errors: UserError with the scene's path.
#pragma once

#include <cstdint>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

// Removes the zones of stage 0; what they lay bare is the grid's boundary.
void leave_out(const scene::Continuum& scene, Grid& grid);

// The stage with which each zone goes, 0 for those that stay. Stages need the scene's statics.
struct ExcavatedZones {
  std::vector<std::uint32_t> stage;  // of each zone; 0: it stays
  std::vector<double> held;          // of each zone: the share of its forces that stays until the next stage
};
ExcavatedZones excavated_zones(const scene::Scene& scene, const Grid& grid);

}  // namespace adit::fdm

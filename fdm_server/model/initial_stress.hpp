// The stress of the ground before anything acts: in each zone that of its centre. A column whose vertical
// stress grows by its weight is then in equilibrium to rounding, because the grid's masses are lumped.
#pragma once

#include <optional>
#include <string>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/materials/material.hpp"
#include "fdm_server/zones/zone_set.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

// How far gravity and the stated vertical stress are from balance, in the mean over the zones, where statics
// will change that stress by more than a twentieth; a warning. Loads that act on a part or for a time are not
// judged.
std::optional<std::string> warn_of_imbalance(const scene::Scene& scene, const Grid& grid,
                                             const Ground& ground);

// Of zones that know the pressure of their water.
void set_initial_stress(const scene::Scene& scene, const Grid& grid, ZoneSet& zones);

}  // namespace adit::fdm

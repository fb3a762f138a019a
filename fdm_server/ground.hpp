// From the scene to the materials of the zones.
#pragma once

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/materials/material.hpp"
#include "protocol/scene.pb.h"

namespace adit::fdm {

// The continuum's material, then those of its areas in their order; no zones yet. UserError with the field's
// path where no law can be built of it.
Ground read_ground(const scene::Scene& scene);

// Number of the material of each zone: that of the last area that holds its centre. UserError for an area
// that holds none, where `whole`.
std::vector<std::uint32_t> materials_of_zones(const scene::Continuum& scene, const Grid& grid, bool whole);

}  // namespace adit::fdm

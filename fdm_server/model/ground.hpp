// From the scene to the materials of the zones.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/materials/material.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

// The continuum's material, then those of its areas in their order; no zones yet. UserError with the field's
// path where no law can be built of it.
Ground read_ground(const scene::Scene& scene);

// The largest shear stress of each hysteretic curve, which is the strength that it implies, and the shear
// strain at which it is reached: one sentence for each material that has one.
std::vector<std::string> notes_on_strength(const Ground& ground);

// Where a cyclic resistance is stated, of PM4Sand or of compaction, the constants that follow: one sentence
// for each material.
std::vector<std::string> notes_on_resistance(const scene::Scene& scene, const Ground& ground);

// That zones do not break by `fracture`: one sentence that names the materials, where any states it and
// follows no strength itself.
std::optional<std::string> note_on_fracture(const Ground& ground);

// Where loops dissipate less than the scene's table asks for, one sentence for each material: its worst
// place.
std::vector<std::string> notes_on_loops(const scene::Scene& scene, const Ground& ground);

// Number of the material of each zone at first: that of the last area of stage 0 that holds its centre.
// UserError for an area that holds none.
std::vector<std::uint32_t> materials_of_zones(const scene::Continuum& scene, const Grid& grid);

// Gives the ground the grid's zones: their materials, and the factors of `scatter` at their centres.
// UserError also for a field that cannot be read.
void assign_zones(const scene::Continuum& scene, const Grid& grid, Ground& ground);

// Removes the zones of weight 0.
void compact(Ground& ground, std::span<const double> weights);

}  // namespace adit::fdm

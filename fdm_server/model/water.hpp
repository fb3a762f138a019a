// From the scene's water to the ground's zones. Errors: UserError with the scene's path.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fdm_server/boundaries/free_field.hpp"
#include "fdm_server/grid/grid.hpp"
#include "fdm_server/materials/material.hpp"
#include "fdm_server/solver/loads.hpp"
#include "fdm_server/supports/lining.hpp"
#include "fdm_server/water/flow.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

// Refuses what is not computed with water, and water that nothing holds.
void require_water(const scene::Scene& scene, const Ground& ground, bool alone);

// How much stiff water shortens the time step, and how stiff it has to be; nothing where it does not.
std::optional<std::string> note_on_stiffness(const scene::Scene& scene, const Ground& ground);

// The pressure of water at rest at the centre of each zone in a stage [Pa]; 0 above its level.
std::vector<double> pressures_at_rest(const scene::Scene& scene, const Grid& grid, std::uint32_t stage);

// Zones whose centres the water reaches in any stage are of the wet one of their materials from now on.
void fill_pores(const scene::Scene& scene, const Grid& grid, Ground& ground);

// The water that stands on what is left of the ground: its pressure on every edge that looks upwards and has
// no ground above it, so that openings in the ground are dry; and on the columns beside such edges.
Load weight_of_sea(const scene::Water& water, const Grid& grid, std::span<const double> weights,
                   std::span<const FreeFieldColumn> columns);

// The flow through what is left of the ground; nothing where no wet material states a conductivity. Water
// leaves by the edges that other water stands on, and into dry ground that has pores; linings are tight.
std::optional<Flow> resolve_flow(const scene::Water& water, const Grid& grid, const Ground& ground,
                                 std::span<const double> weights, std::span<const FreeFieldColumn> columns,
                                 std::span<const Lining> linings);

}  // namespace adit::fdm

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
#include "fdm_server/model/water/sea.hpp"
#include "fdm_server/supports/lining.hpp"
#include "fdm_server/water/flow.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

// Refuses what is not computed with water, and water that nothing holds.
void require_water(const scene::Scene& scene, const Grid& grid, const Ground& ground, bool alone);

// How much stiff water shortens the time step, and how stiff it has to be; water that has no effect, or
// nothing against it.
std::vector<std::string> notes_on_water(const scene::Scene& scene, const Ground& ground);

// Zones whose centres the water reaches in any stage are of the wet one of their materials from now on: with
// water that follows the volume of the pores where the last stage leaves them below the water, else drained.
void fill_pores(const scene::Scene& scene, const Grid& grid, Ground& ground);

// The flow through what is left of the ground in a stage; nothing where no wet material states a
// conductivity. Water leaves by the sides that other water stands on, and into ground whose pores are dry or
// drained; linings are tight.
std::optional<Flow> resolve_flow(const scene::Scene& scene, const Grid& grid, const Ground& ground,
                                 std::uint32_t stage, std::span<const double> weights,
                                 const SideShares& shares, std::span<const FreeFieldColumn> columns,
                                 std::span<const Lining> linings);

}  // namespace adit::fdm

// The scene's members: columns, struts, slabs and walls between two places.
// Errors: UserError with the scene's path where an end meets nothing, or a section, a width or a failure is
// impossible.
#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/supports/lining.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

// As the scene lists them. Where several linings lie at one place, a member ends at the first. Adds their own
// points to the grid, and their names to those that are taken.
std::vector<LiningPlan> plan_members(const scene::Scene& scene, std::span<const LiningPlan> linings,
                                     std::set<std::string>& names, Grid& grid);

}  // namespace adit::fdm

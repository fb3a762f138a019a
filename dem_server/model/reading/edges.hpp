// Quiet edges: dashpots through which plane waves leave the discs (Lysmer & Kuhlemeyer 1969).
//
// Across the side c = rho c_p w, along it c = rho c_s w, with the wave speeds of the disc's material and w
// its share of the side: half the way to the next disc along the side at either hand, its radius where there
// is none within two diameters.
#pragma once

#include "dem_server/model/model.hpp"
#include "dem_server/model/placement/groups.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

// Ascending by disc; a disc on two sides has the dashpots of both. UserError for edges that hold no disc.
std::vector<EdgeDashpot> read_edges(const scene::Particles& particles, const std::vector<Group>& groups,
                                    const Placement& placement, const std::vector<std::uint32_t>& group);

}  // namespace adit::dem

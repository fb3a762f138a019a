// Paths along the grid's edges.
// Errors: UserError at `path`, the scene's field, naming the place.
#pragma once

#include <span>
#include <string>

#include "fdm_server/grid/edges.hpp"
#include "fdm_server/supports/curve.hpp"
#include "fdm_server/supports/lining.hpp"

namespace adit::fdm {

// Follows the edges that lie along the curve: both ends within a twentieth of the edge's length of it, and
// apart along it. The path begins and ends at the grid points nearest to the curve's ends, at most half an
// edge away.
Path trace(const Grid& grid, const Edges& edges, const Curve& curve, const std::string& path);

// Puts edges in order that form one chain, open or closed, in the direction in which the first one's zone
// lies on the right.
Path chain(const Grid& grid, std::span<const Edge> edges, const std::string& path);

}  // namespace adit::fdm

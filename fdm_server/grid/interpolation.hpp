// The grid's motion between its points.
#pragma once

#include <span>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "protocol/participant/interface/interface_operator.hpp"

namespace adit::fdm {

// How the velocities at these places, interleaved [m], follow from the grid points: by the bilinear shape
// functions of the zones that hold them; a place that is a grid point is that point's alone. In a sliver
// (samples.hpp), which the grid has lost, the shape functions of the nearest zone go on. UserError where a
// place lies in neither.
std::vector<protocol::OperatorRow> interpolate(const Grid& grid, std::span<const double> places,
                                               std::span<const Corners> slivers = {});

}  // namespace adit::fdm

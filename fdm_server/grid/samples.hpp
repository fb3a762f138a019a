// Where the energy weight of an overlap is sampled, and the weights that the zones get of it.
#pragma once

#include <span>
#include <vector>

#include "fdm_server/grid/grid.hpp"

namespace adit::fdm {

// The grid points, then the middles of all edges, then those of all zones, interleaved x0 y0 x1 y1 … [m].
std::vector<double> sample_points(const Grid& grid);

// Weight of each zone from the samples at its four corners, four edges and its middle: their mean over the
// zone's area by Simpson's rule on the reference square,
//   1/A sum w_ij J_ij sample_ij,  w = (1 4 1) x (1 4 1) / 36 · 4,
// exact for linear weights on every quadrilateral (sample and Jacobian are both bilinear), so that a patch of
// uniform strain passes through the overlap; at least `floor`. A zone whose samples are all 0 has 0.
// Throws protocol::RequestError where there is not one sample for each point.
std::vector<double> zone_weights(const Grid& grid, std::span<const double> samples, double floor);

}  // namespace adit::fdm

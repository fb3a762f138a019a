// Where the energy weight of an overlap is sampled, and the weights that the zones get of it.
#pragma once

#include <array>
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

// Of each zone with a weight: the samples in the middles of its sides, from its point c to c + 1; 0 beside
// zones without weight.
std::vector<std::array<double, 4>> side_shares(const Grid& grid, std::span<const double> samples,
                                               std::span<const double> weights);

// Zones of which the edge of the overlap leaves a sliver: their middle has no weight, and they weigh less
// than 0.01. Their weights become 0, and their shapes are returned, for interpolation.hpp.
//
// Most points of such a zone lie in the inner model alone and belong to light zones only. Next to nothing
// resists their motion, so that the constraint at a particle in the sliver moves them first, by its mismatch
// over their small share of the shape functions: a strain without bound where the ground yields beside it.
// Without them the motion in the sliver is that of the zone next to it, and less than a hundredth of a zone's
// energy is missing.
std::vector<Corners> drop_slivers(const Grid& grid, std::span<const double> samples,
                                  std::vector<double>& weights);

}  // namespace adit::fdm

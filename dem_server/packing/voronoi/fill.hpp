// Fills a box with points at random, with a least distance, until there is room for none.
#pragma once

#include <span>

#include "dem_server/packing/voronoi/cover_discs.hpp"
#include "dem_server/packing/voronoi/margin.hpp"
#include "dem_server/packing/voronoi/point_grid.hpp"
#include "protocol/motion/random.hpp"

namespace adit::dem {

// Adds points outside the margin to those that are there, in none of the discs and so far from every other
// that the cells have this size; where sizes differ, that of the point which comes later counts. Maximal
// Poisson-disc sampling by Ebeida et al. 2012, Comput. Graph. Forum 31, 785: darts are thrown at the squares
// that may still have room, and what remains of these is divided into quarters.
void fill(const Margin& margin, const CellSize& size, std::span<const DiscField> discs,
          motion::Random& random, PointGrid& points);

}  // namespace adit::dem

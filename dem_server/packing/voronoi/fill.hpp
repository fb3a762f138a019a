// Fills a box with points at random, with a least distance, until there is room for none.
#pragma once

#include <span>

#include "dem_server/packing/voronoi/cover_discs.hpp"
#include "dem_server/packing/voronoi/point_grid.hpp"
#include "protocol/motion/random.hpp"

namespace adit::dem {

// Adds points of the box `inside` to those that are there, at least `least` [m] from every other and in none
// of the discs. Maximal Poisson-disc sampling by Ebeida et al. 2012, Comput. Graph. Forum 31, 785: darts are
// thrown at the squares that may still have room, and what remains of these is divided into quarters.
void fill(const geometry::BoundingBox& inside, double least, std::span<const DiscField> discs,
          motion::Random& random, PointGrid& points);

}  // namespace adit::dem

// Cells of Voronoi that end at all lines which a scene draws through its particles.
#pragma once

#include "dem_server/model/placement/placement.hpp"
#include "dem_server/packing/voronoi/cell_size.hpp"

namespace adit::dem {

// UserError below `path` for a finer place that is no smaller, or not stated by shapes.
CellSize size_of(const scene::CellPacking& cells, const std::string& path);

// Of `cells`: cells end at the faces of the ring, at the outlines of groups, of excavations and of `within`,
// and at joints. UserError for a box that holds no cell, or a size that leaves no room for one in a face.
Placement place_cells(const scene::Particles& particles);

}  // namespace adit::dem

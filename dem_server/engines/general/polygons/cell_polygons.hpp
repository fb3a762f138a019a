// Cells as the polygons that they are, where contacts need them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/engines/general/facets/facet_set.hpp"
#include "dem_server/laws/pair_kinematics.hpp"
#include "dem_server/packing/voronoi/voronoi_cells.hpp"

namespace adit::dem {

struct Model;

struct CellPolygons {
  std::vector<CellOutline> outlines;  // none of discs
  std::vector<double> reach;          // of the farthest corner of each cell from its nucleus [m]
  std::vector<double> perimeter;      // [m]
  std::vector<double> side;           // of a regular hexagon of the cell's area [m]

  CellPolygons() = default;
  explicit CellPolygons(const Model& model);
  bool empty() const { return outlines.empty(); }

  // The corners of a cell that has turned as `facets` say, its nucleus being here.
  void place(std::uint32_t cell, const PlaneVector& nucleus, const FacetSet& facets,
             std::vector<geometry::Point>& corners) const;
};

}  // namespace adit::dem

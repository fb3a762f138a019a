// Cells of Voronoi of some points, cut by a box: each holds what lies nearer to its point, the nucleus, than
// to any other.
//
// Boost.Polygon tells which cells touch (neighbours.hpp). Each cell is then cut from the box by the bisectors
// of its nucleus and its neighbours' in doubles, about the nucleus as origin, so that facets lie on the
// bisectors and areas sum to the box's within rounding, however far the cells are from the origin.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "protocol/geometry/bounding_box.hpp"
#include "protocol/geometry/shape.hpp"

namespace adit::dem {

// What two cells share, first < second: a piece of the bisector of their nuclei.
struct Facet {
  std::uint32_t first, second;
  double x_1, y_1, x_2, y_2;  // its ends, with the first cell on the left of the way from 1 to 2 [m]
};

// The piece of one side of the box that bounds a cell.
struct OuterFace {
  std::uint32_t cell;
  double x_1, y_1, x_2, y_2;  // its ends, with the cell on the left [m]
};

// Corners of one cell about its nucleus, counter-clockwise [m].
using CellOutline = std::vector<geometry::Point>;

struct VoronoiCells {
  std::vector<double> x, y;          // nuclei [m]
  std::vector<double> area;          // [m^2]
  std::vector<double> polar_moment;  // of the area about the nucleus [m^4]
  std::vector<double> radius;        // of the largest disc about the nucleus that the cell holds [m]

  // Pieces shorter than 1e-6 of the mean distance of the nuclei, sqrt(area / cells), are left out of both.
  std::vector<Facet> facets;     // ascending by first, then by second
  std::vector<OuterFace> outer;  // ascending by cell, then counter-clockwise

  // Corners of cell i, counter-clockwise: from corner_starts[i] to below corner_starts[i + 1] [m].
  std::vector<double> corner_x, corner_y;
  std::vector<std::uint32_t> corner_starts;

  std::size_t size() const { return x.size(); }
};

std::vector<CellOutline> outlines_of(const VoronoiCells& cells);

// One cell for each point, in their order; no points give no cells. Throws std::invalid_argument if the box
// has no area, if a point lies outside it, or if two points coincide within 2^-30 of the box's extent.
VoronoiCells voronoi_cells(std::span<const geometry::Point> points, const geometry::BoundingBox& box);

}  // namespace adit::dem

// Columns of ground beside the grid: what the ground would do if the grid's side went on for ever.
//
// All points of a row of such a column move alike, so that a row is one point, and a zone of the column has
// the same point left and right: (a, a, b, b). The zones then know vertical and shear strain only, with every
// law.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fdm_server/boundaries/boundary_edge.hpp"
#include "fdm_server/grid/grid.hpp"
#include "fdm_server/solver/loads.hpp"

namespace adit::fdm {

struct FreeFieldColumn {
  double normal_x;                        // of the grid's side: -1 left, 1 right
  double width;                           // [m]
  std::vector<BoundaryEdge> edges;        // of the side, from below
  std::vector<std::uint32_t> side;        // points of the side, from below
  std::uint32_t first_point, first_zone;  // its own, from below

  std::uint32_t point(std::size_t k) const { return first_point + static_cast<std::uint32_t>(k); }
  std::uint32_t top() const { return point(side.size() - 1); }
  std::uint32_t zone(std::size_t k) const { return first_zone + static_cast<std::uint32_t>(k); }
};

// Adds the column beside the edges whose normal is (`normal_x`, 0), as wide as the widest zone there, to the
// grid's end. UserError at `path` where they are no single vertical line.
FreeFieldColumn add_column(Grid& grid, std::span<const BoundaryEdge> outline, double normal_x,
                           const std::string& path);

// What acts on masses, and what is prescribed to points, is the same in the column as in its side. Points
// ascend.
void extend_to_column(const FreeFieldColumn& column, std::span<const double> masses, Load& body_load);
void extend_to_column(const FreeFieldColumn& column, std::vector<std::uint32_t>& points);

}  // namespace adit::fdm

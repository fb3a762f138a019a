// Where faces cross or meet.
#pragma once

#include <numbers>
#include <vector>

#include "dem_server/packing/voronoi/cell_points.hpp"

namespace adit::dem {

// Between the faces at a junction: 35 degrees within rounding.
constexpr double kLeastAngle = 34.9 * std::numbers::pi / 180;

// One of the ways in which a face leaves a junction.
struct JunctionBranch {
  std::size_t face;  // its number
  bool onwards;      // along the line from its first corner on, or counter-clockwise around the circle
  geometry::Point direction;
};

struct Junction {
  geometry::Point point;
  std::vector<JunctionBranch> branches;
};

bool lies_on(const CellFace& face, const geometry::Point& point, double reach);  // within `reach` [m]

// The points that two faces share, within `reach` [m]; of pieces that they share, the ends.
std::vector<geometry::Point> common_points(const CellFace& a, const CellFace& b, double reach);

// The faces with the open ends of lines moved along the line to another face, if this is less than size / 4
// beyond the end or less than size before it, and not beyond the middle of the line's last piece.
std::vector<CellFace> with_ends_on_faces(const std::vector<CellFace>& faces, const CellSize& size);

// The junctions whose faces can all be edges of cells. A branch at less than 35 degrees from one of a face
// that is named earlier is left out; so is a junction nearer than 1.2 size to an earlier one, or to a corner
// of its faces that turns by more than 30 degrees, and one that is left with a single face.
std::vector<Junction> find_junctions(const std::vector<CellFace>& faces, const CellSize& size);

}  // namespace adit::dem

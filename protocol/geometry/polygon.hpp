// Polygons with holes as closed loops of corners.
#pragma once

#include <vector>

#include "protocol/geometry/shape.hpp"

namespace adit::geometry {

// Corners in order, clockwise or counter-clockwise; the last is joined with the first.
using Loop = std::vector<Point>;

struct Side {
  Point from, to;
};
std::vector<Side> sides(const Loop& loop);

// Whether the loop has at least three corners, none twice, and sides that meet in common corners only and
// never turn back along one another.
bool is_simple(const Loop& loop);

// The same for a line of at least two points, which is closed if the last point equals the first.
bool is_simple_line(const std::vector<Point>& line);

// Whether a side of one loop crosses or touches a side of the other.
bool meet(const Loop& a, const Loop& b);

// Distance to the nearest side, negative inside [m]. A point is inside if an odd number of loops encloses it.
double signed_distance(const std::vector<Side>& sides, const Point& point);

// The area that the loops enclose; they must be simple and must not meet. A loop within another is a hole.
std::shared_ptr<const Shape> polygon(const std::vector<Loop>& loops);

}  // namespace adit::geometry

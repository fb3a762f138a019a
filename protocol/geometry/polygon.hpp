// Polygons with holes as closed loops of corners.
#pragma once

#include <vector>

#include "protocol/geometry/shape.hpp"

namespace adit::geometry {

// Corners in order, either way round; the last is joined with the first.
using Loop = std::vector<Point>;

struct Side {
  Point from, to;
};
std::vector<Side> sides(const Loop& loop);

// At least three corners, none twice, and sides that meet in common corners only, without running back.
bool is_simple(const Loop& loop);

// The same of a line of at least two points; it is closed where the last is the first.
bool is_simple_line(const std::vector<Point>& line);

// Whether a side of one loop crosses or touches one of the other.
bool meet(const Loop& a, const Loop& b);

// Negative inside; inside is what an odd number of the loops encloses [m].
double signed_distance(const std::vector<Side>& sides, const Point& point);

// `loops`: simple ones that do not meet.
std::shared_ptr<const Shape> polygon(const std::vector<Loop>& loops);

}  // namespace adit::geometry

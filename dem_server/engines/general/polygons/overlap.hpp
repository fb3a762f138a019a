// What two convex polygons have in common, and how it grows as they move.
//
// A contact whose energy is a function W of the common area a pushes the polygons apart by -W' times the
// gradient of a: along the normal of the chord between the points where their outlines cross, times its
// length, on a line through its middle (Feng & Owen 2004, Eng. Comput. 21, 265). Here the gradient is summed
// over those edges of the common polygon that lie on the first outline, which is the same, and holds as well
// where the outlines cross more than twice.
#pragma once

#include <span>
#include <vector>

#include "protocol/geometry/shape.hpp"

namespace adit::dem {

struct Overlap {
  double area = 0;                    // [m^2]
  double nx = 0, ny = 0;              // of the chord, from the first polygon to the second
  double chord = 0;                   // [m]
  double middle_x = 0, middle_y = 0;  // centroid of what is common [m]
  double x = 0, y = 0;                // on the line on which they push, nearest to it [m]
};

// Room, of no use between two calls.
struct OverlapWork {
  struct Corner {
    double x, y;
    bool of_first;  // the edge from here to the next corner
  };
  std::vector<Corner> now, next;
};

// Of polygons whose corners ascend counter-clockwise. An area of 0 says that they have nothing in common.
Overlap overlap_of(std::span<const geometry::Point> first, std::span<const geometry::Point> second,
                   OverlapWork& work);

}  // namespace adit::dem

// How deep a wall lies in a convex polygon.
//
// At each place of the wall inside the polygon, d is the distance to the nearest side. A contact that stores
// k / 2 times the integral of d^2 along the wall pushes the polygon at each place by k d through that side.
// It depends on nothing but where the two are, and so keeps energy, wherever the wall ends: on the polygon's
// flat side the pressure is k d evenly, between two sides the forces along the wall cancel, and on an end
// they push it out of the polygon.
#pragma once

#include <span>

#include "protocol/geometry/shape.hpp"

namespace adit::dem {

struct Depth {
  double stored = 0;      // half the integral of d^2 [m^3]
  double pushing = 0;     // size of the integral of d n, n being the nearest side's outward normal [m^2]
  double nx = 0, ny = 0;  // its direction: of the wall out of the polygon
  double x = 0, y = 0;    // on its line of action, nearest to the middle of d [m]
};

// Of the straight way from `a` to `b` in a polygon whose corners ascend counter-clockwise; d is less by
// `free` [m], and counts where it is positive. Stored is 0 where it nowhere is.
Depth depth_of(const geometry::Point& a, const geometry::Point& b, std::span<const geometry::Point> corners,
               double free);

// The largest d [m]; at most 0 where no part of the way lies inside.
double largest_depth(const geometry::Point& a, const geometry::Point& b,
                     std::span<const geometry::Point> corners);

}  // namespace adit::dem

// Shapes in the plane, with the questions that areas and overlaps ask of them.
#pragma once

#include <array>
#include <memory>

#include "protocol/geometry/bounding_box.hpp"

namespace adit::geometry {

struct Point {
  double x, y;  // [m]
};
std::array<Point, 4> corners(const BoundingBox& box);         // counter-clockwise
double distance(const Point& point, const BoundingBox& box);  // 0 inside [m]

class Shape {
 public:
  virtual ~Shape() = default;
  // Euclidean distance from (x, y) to the shape's boundary, negative inside [m].
  virtual double distance(double x, double y) const = 0;
  // Shortest distance between the shape and the box, 0 where they meet [m].
  virtual double distance(const BoundingBox& box) const = 0;
  // Whether the whole box lies in the shape.
  virtual bool covers(const BoundingBox& box) const = 0;
  // A box around all points that lie outside the shape but within `width` of it; infinite along an axis where
  // these points are.
  virtual BoundingBox box_around(double width) const = 0;
};

// The half-plane that the line through (x, y) bounds; the unit normal points out of it.
std::shared_ptr<const Shape> half_plane(double x, double y, double normal_x, double normal_y);

std::shared_ptr<const Shape> disc(double x, double y, double radius);

// What lies between two circles around (x, y).
std::shared_ptr<const Shape> annulus(double x, double y, double inner_radius, double outer_radius);

}  // namespace adit::geometry

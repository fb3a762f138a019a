// Shapes of the plane, as far as areas and overlaps ask: how far away is it?
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
  // A box around what lies outside the shape, but not further than `width`; infinite where that is.
  virtual BoundingBox box_around(double width) const = 0;
};

// What lies behind the line through (x, y), seen from where the unit normal points to.
std::shared_ptr<const Shape> half_plane(double x, double y, double normal_x, double normal_y);

std::shared_ptr<const Shape> disc(double x, double y, double radius);

}  // namespace adit::geometry

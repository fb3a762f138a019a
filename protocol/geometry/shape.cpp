#include "protocol/geometry/shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace adit::geometry {
namespace {

// A convex shape covers a box if it holds its corners.
bool holds_corners(const Shape& shape, const BoundingBox& box) {
  return std::ranges::all_of(corners(box), [&](const Point& c) { return shape.distance(c.x, c.y) <= 0; });
}

class HalfPlane : public Shape {
 public:
  HalfPlane(double x, double y, double normal_x, double normal_y)
      : x_(x), y_(y), normal_x_(normal_x), normal_y_(normal_y) {}

  double distance(double x, double y) const override { return normal_x_ * (x - x_) + normal_y_ * (y - y_); }

  double distance(const BoundingBox& box) const override {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Point& c : corners(box)) nearest = std::min(nearest, distance(c.x, c.y));
    return std::max(nearest, 0.0);
  }

  bool covers(const BoundingBox& box) const override { return holds_corners(*this, box); }

  // The strip beside an oblique line is bounded along neither axis.
  BoundingBox box_around(double width) const override {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    BoundingBox box{-kInfinity, kInfinity, -kInfinity, kInfinity};
    const double far_x = x_ + normal_x_ * width, far_y = y_ + normal_y_ * width;
    if (normal_y_ == 0) std::tie(box.x_min, box.x_max) = std::minmax(x_, far_x);
    if (normal_x_ == 0) std::tie(box.y_min, box.y_max) = std::minmax(y_, far_y);
    return box;
  }

 private:
  double x_, y_, normal_x_, normal_y_;
};

class Disc : public Shape {
 public:
  Disc(double x, double y, double radius) : centre_{x, y}, radius_(radius) {}

  double distance(double x, double y) const override {
    const double from_x = x - centre_.x, from_y = y - centre_.y;
    return std::sqrt(from_x * from_x + from_y * from_y) - radius_;
  }

  double distance(const BoundingBox& box) const override {
    return std::max(0.0, geometry::distance(centre_, box) - radius_);
  }

  bool covers(const BoundingBox& box) const override { return holds_corners(*this, box); }

  BoundingBox box_around(double width) const override {
    const double reach = radius_ + width;
    return {centre_.x - reach, centre_.x + reach, centre_.y - reach, centre_.y + reach};
  }

 private:
  Point centre_;
  double radius_;
};

class Annulus : public Shape {
 public:
  Annulus(double x, double y, double inner_radius, double outer_radius)
      : hole_(x, y, inner_radius), whole_(x, y, outer_radius) {}

  double distance(double x, double y) const override {
    return std::max(whole_.distance(x, y), -hole_.distance(x, y));
  }

  // A box that lies wholly in the hole is nearest with the corner farthest from the centre.
  double distance(const BoundingBox& box) const override {
    if (!hole_.covers(box)) return whole_.distance(box);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Point& c : corners(box)) nearest = std::min(nearest, -hole_.distance(c.x, c.y));
    return nearest;
  }

  bool covers(const BoundingBox& box) const override { return whole_.covers(box) && hole_.distance(box) > 0; }

  BoundingBox box_around(double width) const override { return whole_.box_around(width); }

 private:
  Disc hole_, whole_;
};

}  // namespace

std::array<Point, 4> corners(const BoundingBox& box) {
  return {{{box.x_min, box.y_min}, {box.x_max, box.y_min}, {box.x_max, box.y_max}, {box.x_min, box.y_max}}};
}

double distance(const Point& point, const BoundingBox& box) {
  const double gap_x = point.x - std::clamp(point.x, box.x_min, box.x_max);
  const double gap_y = point.y - std::clamp(point.y, box.y_min, box.y_max);
  return std::sqrt(gap_x * gap_x + gap_y * gap_y);
}

std::shared_ptr<const Shape> half_plane(double x, double y, double normal_x, double normal_y) {
  return std::make_shared<HalfPlane>(x, y, normal_x, normal_y);
}

std::shared_ptr<const Shape> disc(double x, double y, double radius) {
  return std::make_shared<Disc>(x, y, radius);
}

std::shared_ptr<const Shape> annulus(double x, double y, double inner_radius, double outer_radius) {
  return std::make_shared<Annulus>(x, y, inner_radius, outer_radius);
}

}  // namespace adit::geometry

#include "coupler/tunnel/contour.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <numbers>

#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

using geometry::Point;
using std::numbers::pi;

constexpr int kArchSides =
    48;  // of the polygon that stands for a half circle: 0.05 % of the radius inside it

void set(scene::Point& point, const Point& place) {
  point.set_x(place.x);
  point.set_y(place.y);
}

template <class Corners>
void add(Corners& corners, const std::vector<Point>& places) {
  for (const Point& place : places) set(*corners.Add(), place);
}

}  // namespace

Contour::Contour(const scene::LinedTunnel& tunnel, const std::string& path)
    : centre_{tunnel.centre().x(), tunnel.centre().y()} {
  switch (tunnel.shape_case()) {
    case scene::LinedTunnel::kCircle:
      half_width_ = above_ = below_ = radius_ = tunnel.circle().radius();
      is_circle_ = true;
      return;
    case scene::LinedTunnel::kHorseshoe:
      half_width_ = above_ = radius_ = tunnel.horseshoe().width() / 2;
      below_ = tunnel.horseshoe().height() - radius_;
      if (!(below_ > 0))
        throw protocol::UserError(
            path + ".horseshoe.height",
            fmt::format(
                "is {:g} m, but the arch over a width of {:g} m is {:g} m high alone; give more, or a circle",
                tunnel.horseshoe().height(), tunnel.horseshoe().width(), radius_));
      return;
    case scene::LinedTunnel::kBox:
      half_width_ = tunnel.box().width() / 2;
      above_ = below_ = tunnel.box().height() / 2;
      return;
    case scene::LinedTunnel::SHAPE_NOT_SET:
      throw protocol::UserError(path, "has no shape; give a circle, a horseshoe or a box");
  }
}

geometry::BoundingBox Contour::box(double offset) const {
  return {centre_.x - half_width_ - offset, centre_.x + half_width_ + offset, centre_.y - below_ - offset,
          centre_.y + above_ + offset};
}

Point Contour::on_arc(double angle, double offset) const {
  const double radius = radius_ + offset;
  return {centre_.x + radius * std::cos(angle), centre_.y + radius * std::sin(angle)};
}

Point Contour::wall_end(int right, int up, double offset) const {
  const auto [x_min, x_max, y_min, y_max] = box(offset);
  return {right > 0 ? x_max : x_min, up > 0 ? y_max : up < 0 ? y_min : centre_.y};
}

// Of a horseshoe or a box, counter-clockwise from the lower right.
std::vector<Point> Contour::corners(double offset) const {
  const auto [left, right, lower, upper] = box(offset);
  if (radius_ == 0) return {{right, lower}, {right, upper}, {left, upper}, {left, lower}};
  std::vector<Point> corners{{right, lower}};
  for (int k = 0; k <= kArchSides; ++k) corners.push_back(on_arc(pi * k / kArchSides, offset));
  corners.push_back({left, lower});
  return corners;
}

scene::Shape Contour::shape(double offset) const {
  scene::Shape shape;
  if (is_circle_) {
    set(*shape.mutable_circle()->mutable_centre(), centre_);
    shape.mutable_circle()->set_radius(radius_ + offset);
  } else {
    add(*shape.mutable_polygon()->mutable_corners(), corners(offset));
  }
  return shape;
}

scene::Area Contour::inside(double offset) const {
  const scene::Shape whole = shape(offset);
  scene::Area area;
  if (is_circle_)
    *area.mutable_circle() = whole.circle();
  else
    *area.mutable_polygon() = whole.polygon();
  return area;
}

scene::Area Contour::between(double inner_offset, double outer_offset) const {
  scene::Area area;
  if (is_circle_) {
    set(*area.mutable_annulus()->mutable_centre(), centre_);
    area.mutable_annulus()->set_inner_radius(radius_ + inner_offset);
    area.mutable_annulus()->set_outer_radius(radius_ + outer_offset);
  } else {
    area = inside(outer_offset);
    add(*area.mutable_polygon()->add_holes()->mutable_corners(), corners(inner_offset));
  }
  return area;
}

scene::BarPath Contour::around(double offset) const {
  scene::BarPath path;
  if (is_circle_) {
    set(*path.mutable_circle()->mutable_centre(), centre_);
    path.mutable_circle()->set_radius(radius_ + offset);
  } else {
    std::vector<Point> line = corners(offset);
    line.push_back(line.front());
    add(*path.mutable_line()->mutable_points(), line);
  }
  return path;
}

double Contour::length() const {
  if (is_circle_) return 2 * pi * radius_;
  const bool arched = radius_ > 0;
  return 2 * ((arched ? 0 : above_) + below_) + (arched ? pi * radius_ : 2 * half_width_) + 2 * half_width_;
}

Contour::Cut Contour::cut_at_angle(double angle) const {
  return {on_arc(angle, 0), std::cos(angle), std::sin(angle)};
}

// The inner side runs up the right wall from the height of the centre, over the arch or the roof, down the
// left wall, along the floor, and up again.
Contour::Cut Contour::cut(double share) const {
  if (is_circle_) return cut_at_angle(2 * pi * share);
  const auto [left, right, lower, upper] = box(0);
  const bool arched = radius_ > 0;
  const double wall = arched ? 0 : above_, top = arched ? pi * radius_ : 2 * half_width_;
  double along = share * length();
  if (along < wall) return {{right, centre_.y + along}, 1, 0};
  along -= wall;
  if (along < top) {
    if (arched) return cut_at_angle(along / radius_);
    return {{right - along, upper}, 0, 1};
  }
  along -= top;
  if (along < wall + below_) return {{left, centre_.y + wall - along}, -1, 0};
  along -= wall + below_;
  if (along < 2 * half_width_) return {{left + along, lower}, 0, -1};
  return {{right, lower + along - 2 * half_width_}, 1, 0};
}

}  // namespace adit::coupler

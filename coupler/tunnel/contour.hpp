// The outline of a tunnel, and the lines at a distance outside it.
#pragma once

#include <string>
#include <vector>

#include "protocol/geometry/shape.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::coupler {

// Offsets are distances outside the inner side of the lining [m]; corners stay corners.
class Contour {
 public:
  // `path`: of the tunnel in the scene. Throws protocol::UserError for a tunnel without shape, and for a
  // horseshoe that is no higher than its arch.
  Contour(const scene::LinedTunnel& tunnel, const std::string& path);

  const geometry::Point& centre() const { return centre_; }
  geometry::BoundingBox box(double offset) const;
  // On the circle or the arch, at an angle from x.
  geometry::Point on_arc(double angle, double offset) const;
  // An end of a wall: `right` 1 or -1; `up` -1 at the floor, 1 at the roof, 0 at the height of the centre.
  geometry::Point wall_end(int right, int up, double offset) const;
  scene::Shape shape(double offset) const;
  scene::Area inside(double offset) const;
  scene::BarPath around(double offset) const;  // the whole line
  scene::Area between(double inner_offset, double outer_offset) const;

  // A straight cut across the lining, at right angles to its inner side.
  struct Cut {
    geometry::Point place;  // on the inner side
    double nx, ny;          // unit vector outwards
    geometry::Point at(double offset) const { return {place.x + offset * nx, place.y + offset * ny}; }
  };
  double length() const;  // of the inner side [m]
  // At a share of it, counter-clockwise from the height of the centre on the right.
  Cut cut(double share) const;
  // At an angle from x around the centre of a circle.
  Cut cut_at_angle(double angle) const;

 private:
  std::vector<geometry::Point> corners(double offset) const;

  geometry::Point centre_{};
  double half_width_ = 0, above_ = 0, below_ = 0;  // from the centre [m]
  double radius_ = 0;                              // of the circle or the arch; 0 for a box [m]
  bool is_circle_ = false;
};

}  // namespace adit::coupler

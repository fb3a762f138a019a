// A line through the plane on which a lining or a bolt shall lie.
#pragma once

#include <memory>
#include <vector>

#include "protocol/geometry/shape.hpp"

namespace adit::fdm {

class Curve {
 public:
  virtual ~Curve() = default;
  virtual double length() const = 0;  // [m]
  virtual bool closed() const = 0;
  virtual geometry::Point at(double s) const = 0;  // s from the start [m]
  struct Foot {
    double s, distance;  // of the nearest point of the curve [m]
  };
  virtual Foot foot(const geometry::Point& place) const = 0;
};

// Counter-clockwise from one angle to a larger one [rad]; a whole circle where they differ by 2 pi.
std::unique_ptr<Curve> arc(const geometry::Point& centre, double radius, double from, double to);
// At least two points, of which none follows itself.
std::unique_ptr<Curve> polyline(std::vector<geometry::Point> points);

}  // namespace adit::fdm

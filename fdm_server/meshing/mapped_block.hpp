// A structured block of quadrilateral zones: four sides, and how they are divided.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/geometry/shape.hpp"

namespace adit::fdm {

using geometry::Point;

struct Division {
  std::uint32_t zones;
  double ratio;         // size of each zone over that of the one before it
  bool from_both_ends;  // the ratio counts from both ends towards the middle
};

// Places of the zones' ends between 0 and 1.
std::vector<double> places(const Division& division);

// A straight line, or an arc around a centre from its first point on.
class Side {
 public:
  Side() = default;
  Side(const Point& from, const Point& to) : from_(from), to_(to) {}
  // `sweep`: the angle from `from` to `to`, counter-clockwise positive [rad].
  Side(const Point& from, const Point& to, const Point& centre, double sweep)
      : from_(from), to_(to), arc_{{centre, sweep}} {}

  Point at(double s) const;  // s in [0, 1], equal steps of equal length; both ends exact

 private:
  struct Arc {
    Point centre;
    double sweep;
  };
  Point from_{}, to_{};
  std::optional<Arc> arc_;
};

// Sides lower, right, upper, left; lower and upper run along u, left and right along v.
struct MappedBlock {
  std::string name;  // of its group; empty: none
  std::array<Side, 4> sides;
  Division along, across;  // u, v
};

// The block's points, u fastest: transfinite interpolation of the sides (Gordon & Hall 1973),
//   (1-v) lower(u) + v upper(u) + (1-u) left(v) + u right(v) - the bilinear map of the corners.
std::vector<Point> points(const MappedBlock& block);

}  // namespace adit::fdm

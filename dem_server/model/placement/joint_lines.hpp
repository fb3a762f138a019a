// Lines across which discs are joined otherwise.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dem_server/packing/discs.hpp"
#include "protocol/geometry/shape.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

// A straight line from one place to another.
class JointLine {
 public:
  JointLine(const geometry::Point& from, const geometry::Point& to);
  // Whether the line parts the discs: the one between their centres crosses it. A centre on it counts to its
  // left.
  bool parts(const geometry::Point& first, const geometry::Point& second) const;
  bool parts(const Discs& discs, const Pair& pair) const;
  // How far the way from the first place to the second crosses the line: 1 from left to right, -1 from right
  // to left, half of it where one of them lies on the line, else 0.
  double crossing(const geometry::Point& first, const geometry::Point& second) const;
  // The unit normal, from the side of the pair's first disc to that of its second.
  std::array<double, 2> normal(const Discs& discs, const Pair& pair) const;
  std::array<double, 2> direction() const { return {tx_, ty_}; }  // unit vector along it
  double length() const { return length_; }                       // [m]
  // 1: to its left, -1: to its right, 0: on it, but for the rounding of places.
  int side(const geometry::Point& place) const;

 private:
  double above(const geometry::Point& place) const;  // distance to the left [m]
  bool meets(const geometry::Point& first, const geometry::Point& second) const;
  geometry::Point from_;
  double tx_, ty_, length_;
};

// The radial joints of a ring.
class RingJoints {
 public:
  explicit RingJoints(const scene::SegmentRing& ring);
  bool parts(const Discs& discs, const Pair& pair) const;
  // Unit vector from the centre along a joint.
  std::array<double, 2> direction(std::uint32_t joint) const;

 private:
  double angle(double x, double y) const;  // from the first joint, from 0 to 2 pi
  geometry::Point centre_;
  double first_, step_;
};

}  // namespace adit::dem

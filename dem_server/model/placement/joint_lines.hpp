// Lines across which discs are joined otherwise.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dem_server/packing/discs.hpp"
#include "protocol/geometry/shape.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

// A straight line from one place to another. A centre on it counts to its left.
class JointLine {
 public:
  JointLine(const geometry::Point& from, const geometry::Point& to);
  // Whether the line parts the discs: the one between their centres crosses it.
  bool parts(const geometry::Point& first, const geometry::Point& second) const;
  bool parts(const Discs& discs, const Pair& pair) const;
  // The unit normal, from the side of the pair's first disc to that of its second.
  std::array<double, 2> normal(const Discs& discs, const Pair& pair) const;
  std::array<double, 2> direction() const { return {tx_, ty_}; }  // unit vector along it
  double above(const geometry::Point& place) const;               // distance to the left [m]

 private:
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

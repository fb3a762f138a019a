// What acts on grid points from outside: forces, and velocities that do not yield.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace adit::fdm {

using TimeFactor = std::function<double(double t)>;

// Forces of unit factor on some points.
struct Load {
  std::vector<std::uint32_t> points;
  std::vector<double> fx, fy;  // [N], one of each a point
  TimeFactor factor;           // none: steady, which costs a step next to nothing
};

enum class Axis { kX, kY };

// One velocity component of some points, ascending. No component of a point is named twice.
struct PrescribedMotion {
  std::vector<std::uint32_t> points;
  Axis axis;
  double velocity;  // [m/s], times the factor
  TimeFactor factor;
  // By which the first steps of this stage of statics move the points from where they are [m]; before and
  // afterwards they are held. Motions with one have no velocity.
  double displacement = 0;
  std::uint32_t stage = 0;
};

}  // namespace adit::fdm

// The velocity of the ground over time along x.
#pragma once

#include <string>
#include <vector>

#include "protocol/foundation/bracket.hpp"

namespace adit::foundation {

enum class Direction { kX, kY };

class GroundCourse {
 public:
  GroundCourse() = default;  // at rest
  // Ascending times [s] and places [m], velocities by time and place [m/s]. UserError without a path, "file:
  // ...", if times or places do not ascend.
  GroundCourse(std::vector<double> time, std::vector<double> x, std::vector<double> vx,
               std::vector<double> vy, const std::string& file);

  // The two places between which x [m] lies, for velocities() of any time.
  Bracket place(double x) const { return bracket(x_, x); }

  // One value a place [m/s], linear between the times, constant before the first and after the last.
  void velocities(Direction direction, double time, std::vector<double>& values) const;

 private:
  std::vector<double> time_, x_{0.0};
  std::vector<double> vx_, vy_;  // by time, place; empty at rest
};

}  // namespace adit::foundation

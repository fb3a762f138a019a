// The motion of a rigid body over time.
#pragma once

#include <string>
#include <vector>

#include "protocol/messages/foundation.pb.h"

namespace adit::foundation {

struct BodyVelocity {
  double x, y, spin;  // [m/s], [m/s], [rad/s] counter-clockwise
};

class BodyCourse {
 public:
  // The table of a BodyMotion (foundation.proto), whose content was sent with the scene. Throws UserError at
  // `path`.path if it cannot be read or if its times do not increase.
  BodyCourse(const scene::BodyMotion& motion, const std::string& path);

  // Linear between the times, constant before the first and after the last.
  BodyVelocity at(double time) const;

 private:
  std::vector<double> time_, x_, y_, spin_;
};

}  // namespace adit::foundation

// The velocity of a ground motion at any time.
#pragma once

#include <vector>

#include "protocol/motion/motion.hpp"

namespace adit::motion {

// The velocity [m/s]: zero up to time 0, then the exact integral of the straight lines between the values of
// the acceleration, and its last value after the end of the motion.
class VelocityHistory {
 public:
  explicit VelocityHistory(Motion motion);
  double operator()(double t) const;

 private:
  Motion motion_;
  std::vector<double> velocity_;
};

}  // namespace adit::motion

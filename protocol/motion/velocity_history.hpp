// The velocity of a ground motion at any time.
#pragma once

#include <vector>

#include "protocol/motion/motion.hpp"

namespace adit::motion {

// [m/s]: 0 at time 0 and before, the exact integral of the straight lines between the values of the
// acceleration, and what it ends with afterwards.
class VelocityHistory {
 public:
  explicit VelocityHistory(Motion motion);
  double operator()(double t) const;

 private:
  Motion motion_;
  std::vector<double> velocity_;
};

}  // namespace adit::motion

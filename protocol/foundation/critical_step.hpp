// The time step of what stands on a foundation.
#pragma once

#include <cmath>

namespace adit::foundation {

// A critical step [s], shortened by springs that add `squared` [1/s^2] to the omega^2 of every element
// (springs.hpp).
inline double critical_step(double step, double squared) {
  return 1 / std::hypot(1 / step, std::sqrt(squared) / 2);
}

}  // namespace adit::foundation

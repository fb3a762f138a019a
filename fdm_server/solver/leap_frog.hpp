// What the grid's points and the linings' rotations share of the scheme (continuum.hpp).
#pragma once

#include "protocol/step.hpp"

namespace adit::fdm {

// v(n-1/2) v(n+1/2) of a velocity half a step before, under the acceleration of the step: the leap-frog's
// square of velocity. A start from rest has v(-1/2) = -v(1/2).
inline double velocity_product(const protocol::Step& step, double v, double acceleration) {
  const double kick = step.dt * acceleration;
  return step.from_rest() ? -kick * kick / 4 : v * (v + kick);
}

}  // namespace adit::fdm

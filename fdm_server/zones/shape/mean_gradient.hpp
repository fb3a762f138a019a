// Mean gradient of the bilinear field over a quadrilateral (one-point quadrature, exact for the mean):
//   A <df/dx> = 1/2 [(y1 - y3)(f0 - f2) + (y2 - y0)(f1 - f3)],  y -> -x for d/dy.
// Corners 2 and 3 have the negative coefficients of corners 0 and 1.
#pragma once

#include "fdm_server/grid/grid.hpp"

namespace adit::fdm {

struct MeanGradient {
  double x0, x1;  // d/dx of corners 0 and 1 [1/m]
  double y0, y1;  // d/dy
};

inline MeanGradient mean_gradient(const Corners& c) {
  const double half = 0.5 / area(c);
  return {half * (c.y[1] - c.y[3]), half * (c.y[2] - c.y[0]), half * (c.x[3] - c.x[1]),
          half * (c.x[0] - c.x[2])};
}

}  // namespace adit::fdm

// The hourglass pattern h = xi eta of a quadrilateral: the part of the corners' motion that is no linear field.
#pragma once

#include <array>

#include "fdm_server/grid/grid.hpp"

namespace adit::fdm {

struct HourglassShape {
  // Its amplitude is gamma . v, 0 for every linear field: gamma = 1/4 [h - (h.x) b_x - (h.y) b_y], b the mean gradient.
  std::array<double, 4> gamma;
  struct Point {
    double area;    // that the point stands for: the Jacobian [m^2]
    double hx, hy;  // gradient of h [1/m]
  };
  std::array<Point, 4> points;  // 2 x 2 Gauss points: exact on parallelograms
};
HourglassShape hourglass_shape(const Corners& corners);

}  // namespace adit::fdm

// The hourglass pattern of a quadrilateral, and what resists it.
//
// Any four corner values are those of a linear field plus q times the pattern h = (1, -1, 1, -1):
//   f_a = f_0 + f,x x_a + f,y y_a + q h_a,   f,x = b_x . f,  f,y = b_y . f,
//   q = gamma . f,   gamma = 1/4 [h - (h.x) b_x - (h.y) b_y],
// because b and h are orthogonal and gamma is so to every linear field: q = 0 there on any quadrilateral
// (patch test). A kind of zone says what strain the pattern means. Where the mean of that strain is 0, as in
// both of ours, pattern and linear field share no energy: that of the zone is
//   A/2 [kappa (exx + eyy)^2 + mu (exx - eyy)^2 + mu gxy^2] + 1/2 (Kxx qx^2 + Kyy qy^2 + 2 Kxy qx qy),
// with the mean strains and q of both velocity components, and kinds differ in K only.
#pragma once

#include <array>

#include "fdm_server/grid/grid.hpp"

namespace adit::fdm {

// Mean gradient of the bilinear field over a quadrilateral (one-point quadrature, exact for the mean):
//   A <df/dx> = 1/2 [(y1 - y3)(f0 - f2) + (y2 - y0)(f1 - f3)],  y -> -x for d/dy.
// Corners 2 and 3 have the negative coefficients of corners 0 and 1.
struct MeanGradient {
  double x0, x1;  // d/dx of corners 0 and 1 [1/m]
  double y0, y1;  // d/dy
};

inline MeanGradient mean_gradient(const Corners& c) {
  const double half = 0.5 / area(c);
  return {half * (c.y[1] - c.y[3]), half * (c.y[2] - c.y[0]), half * (c.x[3] - c.x[1]),
          half * (c.x[0] - c.x[2])};
}

inline constexpr std::array<double, 4> kHourglass{1, -1, 1, -1};

// Generalized stresses Q = K q [N], per metre of thickness.
struct HourglassStiffness {
  double xx, yy, xy;  // [Pa]
};

// h.x and h.y, 0 for parallelograms.
inline std::array<double, 2> skewness(const Corners& c) {
  return {(c.x[0] - c.x[1]) + (c.x[2] - c.x[3]), (c.y[0] - c.y[1]) + (c.y[2] - c.y[3])};
}

inline std::array<double, 4> gamma(const Corners& c, const MeanGradient& b) {
  const auto [hx, hy] = skewness(c);
  const double first = hx * b.x0 + hy * b.y0, second = hx * b.x1 + hy * b.y1;
  return {0.25 * (1 - first), 0.25 * (-1 - second), 0.25 * (1 + first), 0.25 * (-1 + second)};
}

}  // namespace adit::fdm

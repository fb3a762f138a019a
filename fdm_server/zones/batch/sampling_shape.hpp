// Where a zone of either kind samples its material: four points that share the change of volume.
//
// The strain at point k is the zone's mean of exx + eyy with the point's own exx - eyy and gamma_xy, so that
// flow without change of volume is one condition a zone, not four: nothing locks. With the mean strain and
// the amplitudes q_x, q_y of the hourglass pattern (hourglass.hpp) and a vector g_k of each point,
//   exx - eyy + g_kx q_x - g_ky q_y,   gamma_xy + g_ky q_x + g_kx q_y.
//
// Mixed discretization: the points are the four triangles, each counted half, and g_k is the gradient of the
// pattern in a triangle (mixed_discretization.hpp).
// Assumed strain: the 2 x 2 Gauss points (assumed_strain.hpp), where the pattern adds exx - eyy = 2 a (h,x
// q_x
// - h,y q_y), the deviator of bending, and no shear. The factor a^2 = kappa/(kappa + mu) gives it the bending
// stiffness E' of assumed_strain.hpp without its change of volume: the two zones are one on rectangles as
// long as the material is elastic.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/materials/plane_law.hpp"
#include "fdm_server/zones/kernel/zone_kernel.hpp"

namespace adit::fdm {

struct SamplingPoint {
  double area;    // that it stands for [m^2]
  double gx, gy;  // [1/m]
};

// Corners 2 and 3 have the negative mean gradient of corners 0 and 1, and the pattern 1/2 - c0, -1/2 - c1.
struct SamplingShape {
  double area;
  double x0, x1, y0, y1;  // mean gradient of corners 0 and 1 [1/m]
  double c0, c1;          // pattern gamma
  std::array<SamplingPoint, 4> points;
};

// 2 a: what the pattern's gradient counts at Gauss points.
inline double bending_factor(const PlaneLaw& law) {
  return 2 * std::sqrt(law.bulk / (law.bulk + law.shear));
}

// Of triangles, from 1 / (2 A_k) and 1 / (2 A): one division serves all five.
[[gnu::always_inline]] inline std::array<SamplingPoint, 4> triangle_points(const Corners& c,
                                                                           double& inverse) {
  const double x10 = c.x[1] - c.x[0], x20 = c.x[2] - c.x[0], x30 = c.x[3] - c.x[0];
  const double y10 = c.y[1] - c.y[0], y20 = c.y[2] - c.y[0], y30 = c.y[3] - c.y[0];
  const double x21 = c.x[2] - c.x[1], x31 = c.x[3] - c.x[1];
  const double y21 = c.y[2] - c.y[1], y31 = c.y[3] - c.y[1];
  const double d0 = x10 * y20 - x20 * y10, d1 = x20 * y30 - x30 * y20;  // twice the areas
  const double d2 = x10 * y30 - x30 * y10, d3 = x21 * y31 - x31 * y21, whole = d0 + d1;
  const double d01 = d0 * d1, d23 = d2 * d3, all = 1 / (d01 * d23 * whole), with_whole = all * whole;
  inverse = all * (d01 * d23);
  const double i0 = with_whole * d23 * d1, i1 = with_whole * d23 * d0;
  const double i2 = with_whole * d01 * d3, i3 = with_whole * d01 * d2;
  // The pattern's differences from a triangle's first corner to the others: (-2, 0), (0, -2), (-2, -2), (2,
  // 0).
  return {{{0.25 * d0, -2 * y20 * i0, 2 * x20 * i0},
           {0.25 * d1, 2 * y20 * i1, -2 * x20 * i1},
           {0.25 * d2, 2 * (y10 - y30) * i2, 2 * (x30 - x10) * i2},
           {0.25 * d3, 2 * y31 * i3, -2 * x31 * i3}}};
}

[[gnu::always_inline]] inline SamplingPoint bending_point(const Corners& c, double xi, double eta,
                                                          double factor) {
  const double x_xi = 0.25 * ((1 - eta) * (c.x[1] - c.x[0]) + (1 + eta) * (c.x[2] - c.x[3]));
  const double y_xi = 0.25 * ((1 - eta) * (c.y[1] - c.y[0]) + (1 + eta) * (c.y[2] - c.y[3]));
  const double x_eta = 0.25 * ((1 - xi) * (c.x[3] - c.x[0]) + (1 + xi) * (c.x[2] - c.x[1]));
  const double y_eta = 0.25 * ((1 - xi) * (c.y[3] - c.y[0]) + (1 + xi) * (c.y[2] - c.y[1]));
  const double jacobian = x_xi * y_eta - x_eta * y_xi, scale = factor / jacobian;
  return {jacobian, scale * (eta * y_eta - xi * y_xi), scale * (xi * x_xi - eta * x_eta)};
}

// `factor`: bending_factor().
template <ZoneKind kKind>
[[gnu::always_inline]] inline SamplingShape sampling_shape(const Corners& c, double factor) {
  const double x20 = c.x[2] - c.x[0], x31 = c.x[3] - c.x[1], y20 = c.y[2] - c.y[0], y31 = c.y[3] - c.y[1];
  const double twice = x20 * y31 - x31 * y20;
  double inverse = 0;  // of twice the area
  std::array<SamplingPoint, 4> points;
  if constexpr (kKind == ZoneKind::kMixedDiscretization) {
    points = triangle_points(c, inverse);
  } else {
    const double gauss = 1 / std::sqrt(3.0);
    points = {bending_point(c, -gauss, -gauss, factor), bending_point(c, gauss, -gauss, factor),
              bending_point(c, gauss, gauss, factor), bending_point(c, -gauss, gauss, factor)};
    inverse = 1 / twice;
  }
  const double x0 = -inverse * y31, x1 = inverse * y20, y0 = inverse * x31, y1 = -inverse * x20;
  const double hx = (c.x[0] - c.x[1]) + (c.x[2] - c.x[3]), hy = (c.y[0] - c.y[1]) + (c.y[2] - c.y[3]);
  return {0.5 * twice, x0, x1, y0, y1, 0.25 * (1 - (hx * x0 + hy * y0)), 0.25 * (-1 - (hx * x1 + hy * y1)),
          points};
}

inline SamplingShape sampling_shape(ZoneKind kind, const Corners& corners, double factor) {
  return kind == ZoneKind::kMixedDiscretization
             ? sampling_shape<ZoneKind::kMixedDiscretization>(corners, factor)
             : sampling_shape<ZoneKind::kAssumedStrain>(corners, factor);
}

}  // namespace adit::fdm

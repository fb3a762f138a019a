// Smooth or rough strip footing on weightless cohesive ground without friction, plane strain: the mean
// pressure at collapse (Prandtl 1920), the same as lower and upper bound.
//
// In ground that yields, with mean stress m (tension positive) and Mohr's circle of radius c, Hencky's
// equations keep m + 2 c theta constant along one family of slip lines, theta their direction. Beside the
// footing the surface is free: s_yy = 0, s_xx = -2c, m = -c. From there to the ground under the footing,
// where s_yy is the major compression, the slip lines turn by a right angle: m = -c - pi c, s_yy = m - c.
#pragma once

#include <numbers>

namespace adit::fdm::oracle {

// Mean pressure under the footing, compression positive [Pa].
inline double prandtl_pressure(double cohesion) {
  return (2 + std::numbers::pi) * cohesion;
}

// Stress in the fan of slip lines about the footing's corner, on the ray `angle` below the free surface, from
// 45 degrees (edge of the wedge beside the footing) to 135 (edge of the wedge under it). The rays and the
// circles about the corner are the slip lines: s_rr = s_tt = m, |s_rt| = c, and equilibrium in rotation gives
// dm/d(angle) = -2 c.
struct PrandtlFan {
  double mean, shear;  // m, s_rt with t the direction of growing angle [Pa]
};
inline PrandtlFan prandtl_fan(double cohesion, double angle) {
  return {-cohesion - 2 * cohesion * (angle - std::numbers::pi / 4), cohesion};
}

}  // namespace adit::fdm::oracle

// Where a zone of either kind samples its material: four points that share the change of volume.
//
// The strain at point k is the zone's mean of exx + eyy with the point's own exx - eyy and gamma_xy, so that
// flow without change of volume is one condition a zone, not four: nothing locks.
//
// Mixed discretization: the points are the four triangles, each counted half (mixed_discretization.hpp).
// Assumed strain: the 2 x 2 Gauss points, where the hourglass pattern adds exx - eyy = 2 a (h,x q_x - h,y
// q_y), the deviator of bending. The factor a^2 = kappa/(kappa + mu) gives it the bending stiffness E' of
// assumed_strain.hpp without its change of volume: the two zones are one on rectangles as long as the
// material is elastic.
#pragma once

#include <array>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/materials/plane_law.hpp"
#include "fdm_server/zones/kernel/zone_kernel.hpp"

namespace adit::fdm {

using CornerValues = std::array<double, 4>;

struct SamplingPoint {
  double area;  // that it stands for
  // coefficients of the corners' velocities: exx - eyy from vx, from vy, gamma_xy from vx, from vy [1/m]
  CornerValues difference_x, difference_y, shear_x, shear_y;
};

struct SamplingShape {
  double area;
  CornerValues x, y;  // mean gradient: exx + eyy is x . vx + y . vy [1/m]
  std::array<SamplingPoint, 4> points;
};

SamplingShape sampling_shape(ZoneKind kind, const Corners& corners, const PlaneLaw& law);

}  // namespace adit::fdm

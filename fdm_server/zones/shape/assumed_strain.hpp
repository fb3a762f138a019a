// Assumed-strain zone: one mean stress and two bending stresses (Belytschko & Bindeman 1991, Comput.
// Methods Appl. Mech. Eng. 88, the "QBI" field).
//
// The hourglass pattern h = xi eta (hourglass.hpp) strains the zone by the assumed field
//   exx = h,x q_x - nu' h,y q_y,   eyy = h,y q_y - nu' h,x q_x,   gamma_xy = 0:
// in-plane bending without the parasitic shear that locks the bilinear zone, and without transverse stress,
// sxx = E' h,x q_x, syy = E' h,y q_y. Its energy 1/2 E' (H_xx q_x^2 + H_yy q_y^2 - 2 nu' H_xy q_x q_y), with
// H_ij = integral of h,i h,j dA, gives the generalized stresses
//   Q_x = E' (H_xx q_x - nu' H_xy q_y),   Q_y = E' (H_yy q_y - nu' H_xy q_x),
// and corner forces gamma Q. On rectangles this is the zone with incompatible modes of Wilson and Taylor.
#pragma once

#include <array>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/materials/plane_law.hpp"
#include "fdm_server/zones/shape/hourglass.hpp"

namespace adit::fdm {

// A place in the zone, at the same distance from its middle as three others.
struct GaussPoint {
  double area;    // the Jacobian; that a Gauss point stands for [m^2]
  double hx, hy;  // gradient of h [1/m]
};
// Gauss points of the zone, 2 x 2: exact on parallelograms.
std::array<GaussPoint, 4> gauss_points(const Corners& corners);
// Its corners.
std::array<GaussPoint, 4> corner_points(const Corners& corners);

HourglassStiffness assumed_strain_stiffness(const Corners& corners, const PlaneLaw& law);

}  // namespace adit::fdm

// What the hourglass pattern of an elastic zone adds to its mean stress, where it is largest: at the corners
// of an assumed-strain zone, that is in the outermost fibre where it bends, and in the triangles of a
// mixed-discretization zone.
//
// The amplitudes follow from the generalized stresses, q = K^-1 Q (hourglass.hpp); the stress then from
// sxx = E' h,x q_x, syy = E' h,y q_y (assumed_strain.hpp), or from t = mu (g_x q_x - g_y q_y),
// s = mu (g_y q_x + g_x q_y) (mixed_discretization.hpp).
#pragma once

#include <array>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/materials/plane_law.hpp"
#include "fdm_server/zones/kernel/zone_kernel.hpp"

namespace adit::fdm {

// (sxx + syy)/2, (sxx - syy)/2 and sxy by Q_x and by Q_y [1/m].
struct PatternStress {
  std::array<double, 2> mean, difference, shear;
};

std::array<PatternStress, 4> pattern_stresses(ZoneKind kind, const Corners& corners, const PlaneLaw& law);

}  // namespace adit::fdm

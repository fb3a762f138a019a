// Mixed-discretization zone of FLAC (Marti & Cundall 1982, Int. J. Numer. Anal. Methods Geomech. 6): two
// overlays of two constant-strain triangles, (0 1 2)(0 2 3) and (0 1 3)(1 2 3). The isotropic part of the
// strain is averaged over each overlay's pair by area; corner forces are the mean of the two overlays.
//
// The triangles have the quadrilateral's straight sides, hence the area integral of a field's gradient is the
// same boundary integral in both overlays, and equals that of the bilinear field: the averaged isotropic
// strain is the mean gradient's, and p is one value a zone. The deviatoric stresses t, s (plane_law.hpp) live
// on the four triangles k, each counted half. While all are elastic they need not be stored: with the corner
// values split into linear field and pattern (hourglass.hpp), and g_k the gradient of the pattern h in
// triangle k,
//   t_k = t + mu (g_kx q_x - g_ky q_y),   s_k = s + mu (g_ky q_x + g_kx q_y),
// t and s those of the mean gradient. The sum of A_k g_k over either overlay is the mean gradient of h, 0: no
// energy is shared. What the pattern adds, sum of A_k/4 (dt_k^2 + ds_k^2)/mu, is 1/2 K (q_x^2 + q_y^2) with
//   K = mu sum A_k/2 |g_k|^2.
//
// Too stiff in bending where zones are large, because the triangles' deviatoric strain locks: n rows of zones
// of width a and height b have a section stiffer by (3 mu/E' (1 + a^2/b^2) - 1)/n^2.
#pragma once

#include <array>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/materials/plane_law.hpp"
#include "fdm_server/zones/shape/hourglass.hpp"

namespace adit::fdm {

// Corners of the triangles, in the order above.
inline constexpr std::array<std::array<std::size_t, 3>, 4> kTriangles{
    {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}}};

// Gradient in a triangle of a field that is 0 at its first corner: from the differences to the other two.
struct TriangleGradient {
  double x1, x2, y1, y2;  // [1/m]
};

struct Triangles {
  std::array<TriangleGradient, 4> gradients;
  std::array<double, 4> areas;  // [m^2]
};
Triangles triangles(const Corners& corners);
// Of the pattern h in each triangle: d/dx, d/dy [1/m].
std::array<std::array<double, 2>, 4> pattern_gradients(const Triangles& triangles);

HourglassStiffness mixed_discretization_stiffness(const Corners& corners, const PlaneLaw& law);

}  // namespace adit::fdm

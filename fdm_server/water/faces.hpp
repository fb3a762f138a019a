// The ways of the water from zone to zone, as finite volumes with the pressure at the centre of each zone.
//
// Darcy: water flows by -k grad u [m/s], u the excess pressure [Pa] and k = diag(k_x, k_y) the mobility, the
// hydraulic conductivity over the unit weight of water [m^2/(Pa s)]. Of a side of the length L, let N = L n
// be the normal from zone a to zone b, t along the side, and w = k N. What leaves a is -w_a.grad_a u, and
// what comes into b is -w_b.grad_b u. The centre of a zone lies at d from the side; with
//   alpha = n.k n L/d,   w_a = alpha_a (y - c_a) + s,   w_b = alpha_b (c_b - y) + s
// both are split into a part towards a point y of the side and a rest s along it. There is one y for which
// both rests are the same (the harmonic point of Agelas, Eymard & Herbin 2009, C. R. Acad. Sci. Paris I 347);
// the sum of both equations, each over its alpha, has no y:
//   s = T (w_a/alpha_a + w_b/alpha_b - (c_b - c_a)),   1/T = 1/alpha_a + 1/alpha_b.
// Since both flows are equal and u along the side is the same from both zones, u at y is the mean of u_a and
// u_b weighted by alpha, and the flow from a to b is
//   T (u_a - u_b) - s.grad u:
// two points and a correction along the side, the over-relaxed one of Jasak (1996, thesis, Imperial College).
// It vanishes where the line between the centres is along k n, on rectangles. The gradient is the mean of
// those of both zones. That of a zone is the least squares of one equation for each of its sides, scaled to
// |y - c| = 1: u at y is known,
//   (y - c_a).grad u = T/alpha_a (u_b - u_a),   y - c_a = (w_a - s)/alpha_a,
// with u_b = 0, T = alpha and s = 0 on an open side, and T = 0, which tells that nothing flows along w, on a
// tight one. So flows are exact where u is linear in each ground of one mobility.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "fdm_server/grid/grid.hpp"

namespace adit::fdm {

inline constexpr std::uint32_t kOpenSide = std::numeric_limits<std::uint32_t>::max();

// What a side of a zone lets through.
struct WaterPassage {
  double transmissibility = 0;  // T [m^2/(Pa s)]: volume of water per second and metre of thickness, and Pa
  std::uint32_t beyond =
      0;  // the zone; kOpenSide: no excess pressure; where the side is tight the zone itself
};

using WaterPassages = std::array<WaterPassage, 4>;  // side c of a zone runs from its point c to c + 1

// A zone of which a side needs the correction.
struct SkewedZone {
  std::uint32_t zone;
  std::array<Eigen::Vector2d, 4> slope;  // grad u = sum of slope · (u beyond - u) [1/m]
  std::array<Eigen::Vector2d, 4> cross;  // into the zone flows cross.(grad u + grad u beyond) [m^2 m/(Pa s)]
};

// Ends of an edge: two points, in either order.
using PointPair = std::array<std::uint32_t, 2>;

struct Mobility {
  std::span<const double> x, y;  // of each zone [m^2/(Pa s)]; both 0 where it is dry or tight
};

struct Faces {
  std::vector<WaterPassages> of_zone;
  std::vector<SkewedZone> skewed;  // ascending
};

// Sides between zones with mobility let water through. Other sides of such a zone are tight unless they are
// `open`. `sealed` ones are tight in any case.
Faces make_faces(const Grid& grid, const Mobility& mobility, std::span<const PointPair> open,
                 std::span<const PointPair> sealed);

}  // namespace adit::fdm

#include "fdm_server/participant/large_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fdm_server/output/mean_strain.hpp"

namespace adit::fdm {
namespace {

struct Motion {
  double strain;  // the largest principal one by size
  double turn;    // [rad]
};

Motion motion_of(const Grid& grid, std::size_t zone, std::span<const double> ux, std::span<const double> uy) {
  const ZonePoints& points = grid.zones[zone];
  const MeanGradient gradient = mean_gradient(corners(grid, zone));
  const auto [xx, yy, xy] = mean_strain(gradient, points, ux, uy);
  const double uy_x =
      gradient.x0 * (uy[points[0]] - uy[points[2]]) + gradient.x1 * (uy[points[1]] - uy[points[3]]);
  return {std::abs(xx + yy) / 2 + std::hypot(xx - yy, xy) / 2, std::abs(uy_x - xy / 2)};
}

}  // namespace

void warn_of_large_motion(const Grid& grid, std::span<const double> weights, std::span<const double> ux,
                          std::span<const double> uy, wire::Bye& bye) {
  constexpr double kSmall = 0.1;
  Motion most{0, 0};
  std::size_t where = 0;
  for (std::size_t z = 0; z < grid.own_zones(); ++z) {
    if (weights[z] == 0) continue;
    const Motion motion = motion_of(grid, z, ux, uy);
    if (std::max(motion.strain, motion.turn) <= std::max(most.strain, most.turn)) continue;
    most = motion;
    where = z;
  }
  if (std::max(most.strain, most.turn) <= kSmall) return;
  const auto [x, y] = centroid(corners(grid, where));
  bye.add_warnings(fmt::format(
      "the zone at ({:.4g}, {:.4g}) m has strained by {:.0f} % and turned by {:.0f} degrees, but is "
      "computed in small strain, which is right to about 10 %; give `large_strain: true`, or read it as "
      "failure, not as a displacement",
      x, y, 100 * most.strain, most.turn * 180 / std::numbers::pi));
}

}  // namespace adit::fdm

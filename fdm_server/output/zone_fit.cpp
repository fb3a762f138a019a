#include "fdm_server/output/zone_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>

namespace adit::fdm {
namespace {

Eigen::Vector2d centre(const Grid& grid, std::uint32_t zone) {
  const auto [x, y] = centroid(corners(grid, zone));
  return {x, y};
}

std::vector<std::uint32_t> zones_around(const Grid& grid, std::span<const std::uint32_t> kinds,
                                        std::uint32_t zone) {
  const ZonePoints& own = grid.zones[zone];
  std::vector<std::uint32_t> around;
  for (std::uint32_t z = 0; z < grid.zones.size(); ++z)
    if (z != zone && kinds[z] == kinds[zone] &&
        std::ranges::find_first_of(grid.zones[z], own) != grid.zones[z].end())
      around.push_back(z);
  return around;
}

}  // namespace

ZoneShares fit_around(const Grid& grid, std::span<const std::uint32_t> kinds, std::uint32_t zone, double x,
                      double y) {
  ZoneShares fit{zones_around(grid, kinds, zone), {}};
  const Eigen::Vector2d own = centre(grid, zone);
  Eigen::Matrix2Xd away(2, fit.zones.size());
  for (std::size_t k = 0; k < fit.zones.size(); ++k)
    away.col(static_cast<Eigen::Index>(k)) = centre(grid, fit.zones[k]) - own;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> rows;
  rows.setThreshold(1e-6);  // the slope across a single row of zones is none
  rows.compute(away.transpose());
  const Eigen::VectorXd shares = rows.pseudoInverse().transpose() * (Eigen::Vector2d(x, y) - own);
  fit.shares.assign(shares.begin(), shares.end());
  fit.zones.push_back(zone);
  fit.shares.push_back(1 - shares.sum());
  return fit;
}

}  // namespace adit::fdm

#include "fdm_server/grid/outline.hpp"

#include <cmath>

namespace adit::fdm {

std::vector<BoundaryEdge> outline(const Block& block, const Grid& grid) {
  const double close = 1e-9 * std::hypot(block.x_max - block.x_min, block.y_max - block.y_min);
  const auto on = [close](double first, double second, double side) {
    return std::abs(first - side) <= close && std::abs(second - side) <= close;
  };
  std::vector<BoundaryEdge> edges;
  for (std::uint32_t z = 0; z < grid.zones.size() - grid.column_corners.size(); ++z)
    for (std::size_t c = 0; c < 4; ++c) {
      const auto a = static_cast<std::uint32_t>(grid.zones[z][c]);
      const auto b = static_cast<std::uint32_t>(grid.zones[z][(c + 1) % 4]);
      if (!on(grid.x[a], grid.x[b], block.x_min) && !on(grid.x[a], grid.x[b], block.x_max) &&
          !on(grid.y[a], grid.y[b], block.y_min) && !on(grid.y[a], grid.y[b], block.y_max))
        continue;
      const double dx = grid.x[b] - grid.x[a], dy = grid.y[b] - grid.y[a], length = std::hypot(dx, dy);
      edges.push_back({a, b, z, length, dy / length, -dx / length});
    }
  return edges;
}

}  // namespace adit::fdm

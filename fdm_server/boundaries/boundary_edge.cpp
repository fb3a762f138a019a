#include "fdm_server/boundaries/boundary_edge.hpp"

#include <cmath>

namespace adit::fdm {

std::vector<BoundaryEdge> outline(const Grid& grid) {
  std::vector<BoundaryEdge> edges;
  for (const auto& [from, to, zone] : grid.boundary) {
    const double dx = grid.x[to] - grid.x[from], dy = grid.y[to] - grid.y[from], length = std::hypot(dx, dy);
    edges.push_back({static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to), zone, length,
                     dy / length, -dx / length});
  }
  return edges;
}

}  // namespace adit::fdm

#include "fdm_server/grid/edges.hpp"

#include <algorithm>

namespace adit::fdm {

// The edges of a point, those whose other point has a larger number, are a list linked by their numbers.
Edges number_edges(const Grid& grid) {
  constexpr std::uint32_t kNone = UINT32_MAX;
  std::vector<std::uint32_t> first(grid.x.size(), kNone), next;
  Edges edges;
  edges.of_zone.resize(grid.zones.size());
  // A large grid of quadrilaterals has about two edges a zone.
  edges.list.reserve(2 * grid.zones.size());
  for (std::uint32_t z = 0; z < grid.zones.size(); ++z)
    for (std::size_t c = 0; c < 4; ++c) {
      const std::int32_t from = grid.zones[z][c], to = grid.zones[z][(c + 1) % 4];
      const auto [low, high] = std::minmax(from, to);
      std::uint32_t edge = first[low];
      while (edge != kNone && std::max(edges.list[edge].from, edges.list[edge].to) != high) edge = next[edge];
      if (edge == kNone) {
        edge = static_cast<std::uint32_t>(edges.list.size());
        edges.list.push_back({from, to, z});
        edges.zones.push_back(0);
        next.push_back(first[low]);
        first[low] = edge;
      }
      // A wrong mesh may have any number of zones at an edge; the count must not wrap around to 1, a
      // boundary.
      if (edges.zones[edge] < UINT8_MAX) ++edges.zones[edge];
      edges.of_zone[z][c] = edge;
    }
  return edges;
}

std::vector<Edge> boundary(const Edges& edges) {
  std::vector<Edge> sides;
  for (std::size_t e = 0; e < edges.list.size(); ++e)
    if (edges.zones[e] == 1) sides.push_back(edges.list[e]);
  return sides;
}

}  // namespace adit::fdm

#include "dem_server/packing/voronoi/neighbours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace adit::dem {
namespace {

using Diagram = boost::polygon::voronoi_diagram<double>;
using GridPoint = boost::polygon::point_data<int>;

constexpr double kGridLines = 0x1p30;  // along the box's longer side; Boost.Polygon computes with 32 bits
// Edges of the diagram shorter than this share of the points' mean distance may vanish or turn over when the
// points move by a grid line.
constexpr double kShort = 1e-3;

std::vector<GridPoint> put_on_grid(std::span<const geometry::Point> points, const geometry::BoundingBox& box,
                                   double pitch) {
  const auto line = [pitch](double from_middle) {
    return static_cast<int>(std::lround(from_middle / pitch));
  };
  const double x = (box.x_min + box.x_max) / 2, y = (box.y_min + box.y_max) / 2;
  std::vector<GridPoint> grid;
  grid.reserve(points.size());
  for (const auto& p : points) grid.emplace_back(line(p.x - x), line(p.y - y));
  return grid;
}

void refuse_coincident(const std::vector<GridPoint>& grid, std::span<const geometry::Point> points) {
  std::vector<std::uint32_t> order(grid.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) { return grid[a] < grid[b]; });
  const auto twice =
      std::ranges::adjacent_find(order, [&](std::uint32_t a, std::uint32_t b) { return grid[a] == grid[b]; });
  if (twice == order.end()) return;
  throw std::invalid_argument(fmt::format("points {} and {} of a diagram of cells coincide at ({}, {})",
                                          *twice, *(twice + 1), points[*twice].x, points[*twice].y));
}

std::uint32_t point_of(const Diagram::edge_type& edge) {
  return static_cast<std::uint32_t>(edge.cell()->source_index());
}

// Vertices of the diagram that are joined by short edges, as sets.
class JoinedVertices {
 public:
  JoinedVertices(const Diagram& diagram, double reach) : diagram_(diagram), parent_(diagram.num_vertices()) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    for (const auto& edge : diagram.edges())
      if (edge.is_finite() && length(edge) < reach) parent_[root(*edge.vertex0())] = root(*edge.vertex1());
  }
  std::size_t root(const Diagram::vertex_type& vertex) {
    auto v = static_cast<std::size_t>(&vertex - diagram_.vertices().data());
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }

 private:
  static double length(const Diagram::edge_type& edge) {
    const auto &a = *edge.vertex0(), &b = *edge.vertex1();
    return std::hypot(a.x() - b.x(), a.y() - b.y());
  }
  const Diagram& diagram_;
  std::vector<std::size_t> parent_;
};

// The points around each vertex, or around vertices so close to each other that the grid may have confused
// them: where more than three meet, each may be the neighbour of any other.
void add_pairs_around_vertices(const Diagram& diagram, double reach, std::vector<Pair>& pairs) {
  JoinedVertices joined(diagram, reach);
  std::vector<std::pair<std::size_t, std::uint32_t>> around;  // set of vertices, point
  for (const auto& edge : diagram.edges())
    if (edge.vertex0() != nullptr) around.emplace_back(joined.root(*edge.vertex0()), point_of(edge));
  std::ranges::sort(around);
  around.erase(std::ranges::unique(around).begin(), around.end());
  for (auto first = around.begin(); first != around.end();) {
    const auto last =
        std::find_if(first, around.end(), [&](const auto& a) { return a.first != first->first; });
    if (last - first > 3)
      for (auto a = first; a != last; ++a)
        for (auto b = a + 1; b != last; ++b) pairs.push_back({a->second, b->second});
    first = last;
  }
}

}  // namespace

std::vector<Pair> neighbours_in_diagram(std::span<const geometry::Point> points,
                                        const geometry::BoundingBox& box) {
  const double width = box.x_max - box.x_min, height = box.y_max - box.y_min;
  const double pitch = std::max(width, height) / kGridLines;
  const std::vector<GridPoint> grid = put_on_grid(points, box, pitch);
  refuse_coincident(grid, points);
  Diagram diagram;
  boost::polygon::construct_voronoi(grid.begin(), grid.end(), &diagram);
  std::vector<Pair> pairs;
  for (const auto& edge : diagram.edges())
    if (point_of(edge) < point_of(*edge.twin())) pairs.push_back({point_of(edge), point_of(*edge.twin())});
  const double distance = std::sqrt(width * height / static_cast<double>(points.size()));
  add_pairs_around_vertices(diagram, kShort * distance / pitch, pairs);
  std::ranges::sort(pairs, {}, [](const Pair& pair) { return std::pair(pair.first, pair.second); });
  pairs.erase(std::ranges::unique(pairs).begin(), pairs.end());
  return pairs;
}

}  // namespace adit::dem

#include "dem_server/packing/voronoi/voronoi_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "dem_server/packing/voronoi/neighbours.hpp"

namespace adit::dem {
namespace {

using geometry::BoundingBox;
using geometry::Point;

// Shares of the mean distance of the nuclei: a piece of a cell's edge that is no facet, and a corner that a
// bisector touches rather than cuts off (in a square lattice four cells meet in each corner).
constexpr double kSliver = 1e-6, kTouch = 1e-12;
constexpr std::uint32_t kFirstSide = std::numeric_limits<std::uint32_t>::max() - 3;  // sides of the box

// The half-plane direction * p <= level about a nucleus, beyond which another cell or the outside is.
struct Bound {
  Point direction;
  double level;
  std::uint32_t beyond;  // a cell, or kFirstSide + the number of a side of the box
  double excess(const Point& p) const { return direction.x * p.x + direction.y * p.y - level; }
};

Point crossing(const Bound& a, const Bound& b) {
  const double det = a.direction.x * b.direction.y - a.direction.y * b.direction.x;
  return {(a.level * b.direction.y - b.level * a.direction.y) / det,
          (b.level * a.direction.x - a.level * b.direction.x) / det};
}

Bound bisector(const Point& nucleus, const Point& other, std::uint32_t cell) {
  const Point way{other.x - nucleus.x, other.y - nucleus.y};
  return {way, (way.x * way.x + way.y * way.y) / 2, cell};
}

// A convex polygon about a nucleus: corner k lies where edges k - 1 and k meet, counter-clockwise.
class Outline {
 public:
  Outline(const BoundingBox& box, const Point& nucleus) {
    edges_ = {{{0, -1}, nucleus.y - box.y_min, kFirstSide},
              {{1, 0}, box.x_max - nucleus.x, kFirstSide + 1},
              {{0, 1}, box.y_max - nucleus.y, kFirstSide + 2},
              {{-1, 0}, nucleus.x - box.x_min, kFirstSide + 3}};
    for (std::size_t k = 0; k < 4; ++k) corners_.push_back(crossing(edges_[(k + 3) % 4], edges_[k]));
  }

  // Cuts off what lies beyond the bound. Every new corner is computed from the two lines that meet there, so
  // that the errors of many cuts do not add up. A convex polygon loses one run of its corners.
  void cut(const Bound& bound, double touch) {
    const double least = touch * std::hypot(bound.direction.x, bound.direction.y);
    const std::size_t count = corners_.size();
    const auto beyond = [&](std::size_t k) { return bound.excess(corners_[k % count]) > least; };
    std::size_t from = 0;
    while (from < count && !(beyond(from) && !beyond(from + count - 1))) ++from;
    if (from == count) return;
    std::size_t to = from + 1;
    while (beyond(to)) ++to;
    const Bound before = edges_[(from + count - 1) % count], after = edges_[(to - 1) % count];
    std::vector<Bound> edges{bound, after};
    std::vector<Point> corners{crossing(before, bound), crossing(bound, after)};
    for (std::size_t k = to; k < from + count; ++k) {
      edges.push_back(edges_[k % count]);
      corners.push_back(corners_[k % count]);
    }
    edges_ = std::move(edges);
    corners_ = std::move(corners);
  }

  // A later cut may leave no more than a corner of an edge.
  void drop_edges_shorter_than(double least) {
    for (std::size_t k = edges_.size(); k-- > 0;)
      if (std::hypot(to(k).x - from(k).x, to(k).y - from(k).y) < least) {
        edges_.erase(edges_.begin() + static_cast<std::ptrdiff_t>(k));
        corners_.erase(corners_.begin() + static_cast<std::ptrdiff_t>(k));
      }
  }

  const std::vector<Bound>& edges() const { return edges_; }
  const Point& from(std::size_t edge) const { return corners_[edge]; }
  const Point& to(std::size_t edge) const { return corners_[(edge + 1) % corners_.size()]; }

 private:
  std::vector<Bound> edges_;
  std::vector<Point> corners_;
};

// Neighbours of each point, in compressed rows.
struct Lists {
  std::vector<std::uint32_t> starts, neighbours;
  Lists(std::span<const Pair> pairs, std::size_t points) : starts(points + 1), neighbours(2 * pairs.size()) {
    for (const auto [a, b] : pairs) ++starts[a + 1], ++starts[b + 1];
    for (std::size_t i = 0; i < points; ++i) starts[i + 1] += starts[i];
    auto next = starts;
    for (const auto [a, b] : pairs) neighbours[next[a]++] = b, neighbours[next[b]++] = a;
  }
  std::span<const std::uint32_t> of(std::size_t i) const {
    return std::span(neighbours).subspan(starts[i], starts[i + 1] - starts[i]);
  }
};

// Sums over the triangles of the nucleus and each edge.
void append_sums(const Outline& outline, VoronoiCells& cells) {
  double area = 0, moment = 0, radius = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < outline.edges().size(); ++k) {
    const Point &a = outline.from(k), &b = outline.to(k);
    const double twice = a.x * b.y - a.y * b.x;
    area += twice / 2;
    moment += twice * (a.x * a.x + a.y * a.y + a.x * b.x + a.y * b.y + b.x * b.x + b.y * b.y) / 12;
    const Bound& edge = outline.edges()[k];
    radius = std::min(radius, edge.level / std::hypot(edge.direction.x, edge.direction.y));
  }
  cells.area.push_back(area);
  cells.polar_moment.push_back(moment);
  cells.radius.push_back(radius);
}

void append_edges(const Outline& outline, const Point& nucleus, double sliver, VoronoiCells& cells) {
  const auto cell = static_cast<std::uint32_t>(cells.x.size());
  const auto facets_before = static_cast<std::ptrdiff_t>(cells.facets.size());
  for (std::size_t k = 0; k < outline.edges().size(); ++k) {
    const std::uint32_t beyond = outline.edges()[k].beyond;
    const Point &a = outline.from(k), &b = outline.to(k);
    cells.corner_x.push_back(nucleus.x + a.x);
    cells.corner_y.push_back(nucleus.y + a.y);
    if (std::hypot(b.x - a.x, b.y - a.y) < sliver) continue;
    const double x_1 = nucleus.x + a.x, y_1 = nucleus.y + a.y, x_2 = nucleus.x + b.x, y_2 = nucleus.y + b.y;
    if (beyond >= kFirstSide)
      cells.outer.push_back({cell, x_1, y_1, x_2, y_2});
    else if (cell < beyond)
      cells.facets.push_back({cell, beyond, x_1, y_1, x_2, y_2});
  }
  cells.corner_starts.push_back(static_cast<std::uint32_t>(cells.corner_x.size()));
  std::sort(cells.facets.begin() + facets_before, cells.facets.end(),
            [](const Facet& a, const Facet& b) { return a.second < b.second; });
  cells.x.push_back(nucleus.x);
  cells.y.push_back(nucleus.y);
}

void check(std::span<const Point> points, const BoundingBox& box) {
  if (!(box.x_max > box.x_min && box.y_max > box.y_min))
    throw std::invalid_argument("the box of a diagram of cells has no area");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [x, y] = points[i];
    if (!(x >= box.x_min && x <= box.x_max && y >= box.y_min && y <= box.y_max))
      throw std::invalid_argument(
          fmt::format("point {} of a diagram of cells, ({}, {}), lies outside the box", i, x, y));
  }
}

}  // namespace

std::vector<CellOutline> outlines_of(const VoronoiCells& cells) {
  std::vector<CellOutline> outlines(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::uint32_t k = cells.corner_starts[i]; k < cells.corner_starts[i + 1]; ++k)
      outlines[i].push_back({cells.corner_x[k] - cells.x[i], cells.corner_y[k] - cells.y[i]});
  return outlines;
}

VoronoiCells voronoi_cells(std::span<const Point> points, const BoundingBox& box) {
  check(points, box);
  VoronoiCells cells;
  cells.corner_starts.push_back(0);
  if (points.empty()) return cells;
  const Lists lists(neighbours_in_diagram(points, box), points.size());
  const double distance =
      std::sqrt((box.x_max - box.x_min) * (box.y_max - box.y_min) / static_cast<double>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    Outline outline(box, points[i]);
    for (const std::uint32_t j : lists.of(i))
      outline.cut(bisector(points[i], points[j], j), kTouch * distance);
    outline.drop_edges_shorter_than(kTouch * distance);
    append_sums(outline, cells);
    append_edges(outline, points[i], kSliver * distance, cells);
  }
  return cells;
}

}  // namespace adit::dem

#include "dem_server/model/placement/uncovered.hpp"

#include <algorithm>

#include "dem_server/packing/voronoi/face_path.hpp"
#include "dem_server/packing/voronoi/junctions.hpp"

namespace adit::dem {
namespace {

using geometry::Point;

// The ends of a piece, and between them the points where it meets an outline, from its beginning on.
std::vector<Point> cut_at_outlines(const geometry::Side& piece, const std::vector<Cover>& covers,
                                   double reach) {
  std::vector<Point> points{piece.from, piece.to};
  for (const Cover& cover : covers)
    for (const CellFace& outline : cover.outlines)
      for (const Point& point : common_points(FaceLine{{piece.from, piece.to}}, outline, reach))
        if (std::ranges::none_of(points, [&](const Point& p) { return distance_of(p, point) < reach; }))
          points.push_back(point);
  std::ranges::sort(points, {}, [&](const Point& p) { return distance_of(piece.from, p); });
  return points;
}

bool lies_inside(const std::vector<Cover>& covers, const Point& p) {
  return std::ranges::any_of(covers, [&](const Cover& cover) { return cover.inside.hold(p.x, p.y); });
}

}  // namespace

std::vector<FaceLine> uncovered(const FaceLine& line, const std::vector<Cover>& covers, double reach) {
  std::vector<FaceLine> parts;
  bool whole = true, goes_on = false;
  for (const geometry::Side& piece : pieces_of(line)) {
    const auto points = cut_at_outlines(piece, covers, reach);
    for (std::size_t k = 1; k < points.size(); ++k) {
      const Point &from = points[k - 1], &to = points[k];
      const bool free = !lies_inside(covers, {(from.x + to.x) / 2, (from.y + to.y) / 2});
      if (free && !goes_on) parts.push_back({{from}});
      if (free) parts.back().corners.push_back(to);
      whole = whole && free;
      goes_on = free;
    }
  }
  if (whole) return {line};
  // A closed line is opened at a corner, which may lie within a part.
  if (line.closed && parts.size() > 1 &&
      distance_of(parts.back().corners.back(), parts.front().corners.front()) < reach) {
    auto& first = parts.front().corners;
    auto& last = parts.back().corners;
    last.insert(last.end(), first.begin() + 1, first.end());
    first = std::move(last);
    parts.pop_back();
  }
  return parts;
}

}  // namespace adit::dem

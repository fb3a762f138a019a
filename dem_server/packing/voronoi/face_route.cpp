#include "dem_server/packing/voronoi/face_route.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adit::dem {
namespace {

using geometry::Point;

bool is_one_of(const std::vector<Point>& points, const Point& point, double reach) {
  return std::ranges::any_of(points, [&](const Point& p) { return distance_of(p, point) < reach; });
}

FaceLine with_corner_at(FaceLine line, const Point& point, double reach) {
  if (is_one_of(line.corners, point, reach)) return line;
  const auto pieces = pieces_of(line);
  const auto nearest = std::ranges::min_element(
      pieces, {}, [&](const geometry::Side& piece) { return distance_between(piece, point); });
  line.corners.insert(line.corners.begin() + (nearest - pieces.begin()) + 1, point);
  return line;
}

Route along_line(FaceLine line, const std::vector<Point>& junctions, const CellSize& size) {
  const double reach = kTheSamePoint * size.least();
  for (const Point& point : junctions) line = with_corner_at(std::move(line), point, reach);
  const std::vector<Point> points = opened(line);
  const std::vector<double> turns = turns_of(points, line.closed);
  const auto at_junction = [&](std::size_t k) { return is_one_of(junctions, points[k], reach); };
  std::vector<bool> fixed;
  for (std::size_t k = 0; k < points.size(); ++k) fixed.push_back(is_sharp(turns[k]) || at_junction(k));
  const std::vector<std::size_t> kept = corners_with_discs(points, turns, fixed, size);
  Route route{{}, {}, line.closed};
  for (std::size_t k = 0; k < kept.size(); ++k) {
    route.corners.push_back({points[kept[k]], is_sharp(turns[kept[k]]), at_junction(kept[k])});
    if (k + 1 < kept.size())
      route.paths.push_back(path_along({points.begin() + static_cast<std::ptrdiff_t>(kept[k]),
                                        points.begin() + static_cast<std::ptrdiff_t>(kept[k + 1]) + 1}));
  }
  return route;
}

Route around_circle(const FaceCircle& circle, std::vector<Point> junctions) {
  const auto angle_of = [&](const Point& p) {
    return std::atan2(p.y - circle.centre.y, p.x - circle.centre.x);
  };
  std::ranges::sort(junctions, {}, angle_of);
  Route route{{}, {}, true};
  if (junctions.empty()) return route;
  junctions.push_back(junctions.front());
  for (std::size_t k = 0; k < junctions.size(); ++k) {
    route.corners.push_back({junctions[k], false, true});
    if (k + 1 == junctions.size()) break;
    const double from = angle_of(junctions[k]), to = angle_of(junctions[k + 1]);
    const double angle = k + 2 == junctions.size() ? to - from + 2 * std::numbers::pi : to - from;
    route.paths.push_back(path_around(circle, from, circle.radius * angle));
  }
  return route;
}

}  // namespace

Route route_along(const CellFace& face, const std::vector<Point>& junctions, const CellSize& size) {
  if (const auto* line = std::get_if<FaceLine>(&face)) return along_line(*line, junctions, size);
  return around_circle(std::get<FaceCircle>(face), junctions);
}

}  // namespace adit::dem

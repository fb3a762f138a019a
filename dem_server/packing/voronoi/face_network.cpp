#include "dem_server/packing/voronoi/face_network.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adit::dem {
namespace {

using geometry::Point;

// The path that leaves a corner of a route onwards, or comes to it.
Ray ray_at(const Route& route, std::size_t face, std::size_t corner, bool onwards) {
  const std::size_t count = route.paths.size();
  return {face, onwards ? corner % count : (corner + count - 1) % count, onwards};
}

Vertex vertex_at(const Junction& junction, const std::vector<Route>& routes) {
  Vertex vertex{junction.point, {}};
  auto branches = junction.branches;
  std::ranges::sort(branches, {},
                    [](const JunctionBranch& b) { return std::atan2(b.direction.y, b.direction.x); });
  for (const auto& [face, onwards, direction] : branches) {
    const auto& corners = routes[face].corners;
    const auto corner = std::ranges::min_element(
        corners, {}, [&](const RouteCorner& c) { return distance_of(c.point, junction.point); });
    vertex.rays.push_back(
        ray_at(routes[face], face, static_cast<std::size_t>(corner - corners.begin()), onwards));
  }
  return vertex;
}

// The line turns by less than two right angles, so that either order of two rays is counter-clockwise.
void add_sharp_corners(const Route& route, std::size_t face, std::vector<Vertex>& vertices) {
  const std::size_t count = route.closed ? route.paths.size() : route.corners.size();
  for (std::size_t k = 0; k < count; ++k)
    if (const auto& [point, sharp, at_junction] = route.corners[k]; sharp && !at_junction)
      vertices.push_back({point, {ray_at(route, face, k, false), ray_at(route, face, k, true)}});
}

}  // namespace

FaceNetwork connect_faces(const std::vector<CellFace>& faces, const CellSize& size) {
  const auto junctions = find_junctions(faces, size);
  std::vector<std::vector<Point>> of_face(faces.size());
  for (const auto& [point, branches] : junctions)
    for (const JunctionBranch& branch : branches)
      if (auto& points = of_face[branch.face]; points.empty() || distance_of(points.back(), point) > 0)
        points.push_back(point);
  FaceNetwork network;
  for (std::size_t face = 0; face < faces.size(); ++face)
    network.routes.push_back(route_along(faces[face], of_face[face], size));
  for (const Junction& junction : junctions) network.vertices.push_back(vertex_at(junction, network.routes));
  for (std::size_t face = 0; face < faces.size(); ++face)
    add_sharp_corners(network.routes[face], face, network.vertices);
  return network;
}

std::vector<double> sectors_between(const std::vector<Point>& directions) {
  std::vector<double> sectors;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const Point &a = directions[k], &b = directions[(k + 1) % directions.size()];
    const double angle = std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
    sectors.push_back(angle < 0 ? angle + 2 * std::numbers::pi : angle);
  }
  return sectors;
}

}  // namespace adit::dem

#include "dem_server/packing/voronoi/room_beside.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "dem_server/packing/voronoi/face_path.hpp"
#include "dem_server/packing/voronoi/junctions.hpp"

namespace adit::dem {
namespace {

using geometry::Point;

// Least cosine between the normals of faces that run beside each other, and of rays that share their room.
// Other faces whose normals are closer than 35 degrees form no junction, and smaller cells would not help
// where they meet.
constexpr double kBeside = 0.9, kSharing = 0.64;
constexpr double kClosest = 0.48;  // of the size: distance of faces that do not meet

// Calls visit(distance, cosine between the normals) if the ray from a point along a unit vector meets the
// piece.
template <class Visit>
void visit_crossing(const Point& from, const Point& to, const Point& point, const Point& ray, Visit&& visit) {
  const double along_x = to.x - from.x, along_y = to.y - from.y;
  const double across = ray.x * along_y - ray.y * along_x, length = std::hypot(along_x, along_y);
  if (std::abs(across) < kSharing * length) return;
  const double x = from.x - point.x, y = from.y - point.y;
  const double share = (x * ray.y - y * ray.x) / across;
  if (share >= 0 && share <= 1) visit((x * along_y - y * along_x) / across, std::abs(across) / length);
}

// The same for both points in which the ray meets the circle.
template <class Visit>
void visit_crossings(const FaceCircle& circle, const Point& point, const Point& ray, Visit&& visit) {
  const double x = circle.centre.x - point.x, y = circle.centre.y - point.y;
  const double nearest = x * ray.x + y * ray.y, aside = x * ray.y - y * ray.x;
  const double half = std::sqrt(std::max(circle.radius * circle.radius - aside * aside, 0.0));
  if (half < kSharing * circle.radius) return;
  visit(nearest - half, half / circle.radius);
  visit(nearest + half, half / circle.radius);
}

}  // namespace

RoomBeside::RoomBeside(const CellPacking& wanted) : faces_(wanted.faces), size_(wanted.size) {
  for (std::size_t face = 0; face < wanted.faces.size(); ++face)
    if (const auto* line = std::get_if<FaceLine>(&wanted.faces[face])) {
      for (const auto& [from, to] : pieces_of(*line)) pieces_.push_back({from, to, face});
    } else {
      circles_.push_back({std::get<FaceCircle>(wanted.faces[face]), face});
    }
  const auto corners = geometry::corners(wanted.box);
  for (std::size_t k = 0; k < 4; ++k) sides_.push_back({corners[k], corners[(k + 1) % 4], 0});
}

void RoomBeside::refuse_close(std::size_t face, std::size_t other, double size) const {
  if (!common_points(faces_[face], faces_[other], kTheSamePoint * size_.least()).empty()) return;
  throw std::invalid_argument(
      fmt::format("faces {} and {} of a packing of cells are less than {:.4g} m apart, half the size of a "
                  "cell, but meet nowhere",
                  std::min(face, other), std::max(face, other), size / 2));
}

double RoomBeside::at(const Point& point, const Point& normal, std::size_t face) const {
  const double size = size_.at(point);
  double room = std::numeric_limits<double>::infinity();
  for (const Point& ray : {normal, Point{-normal.x, -normal.y}}) {
    const auto take_from = [&](std::size_t other) {
      return [&, other](double distance, double cosine) {
        if (distance < (other == face ? size / 4 : kTheSamePoint * size)) return;
        if (other != face && cosine > std::cos(kLeastAngle) && cosine < kBeside) return;
        if (distance < kClosest * size && cosine >= kBeside && other != face) refuse_close(face, other, size);
        room = std::min(room, distance * 2 * cosine / (1 + cosine));  // twice that to the bisector
      };
    };
    for (const auto& [from, to, other] : pieces_) visit_crossing(from, to, point, ray, take_from(other));
    for (const auto& [circle, other] : circles_) visit_crossings(circle, point, ray, take_from(other));
    for (const auto& [from, to, none] : sides_)
      visit_crossing(from, to, point, ray, [&](double distance, double cosine) {
        if (distance > 0 && cosine >= kBeside) room = std::min(room, 2 * distance);
      });
  }
  return room;
}

}  // namespace adit::dem

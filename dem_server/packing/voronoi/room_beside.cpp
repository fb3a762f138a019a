#include "dem_server/packing/voronoi/room_beside.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "dem_server/packing/voronoi/face_path.hpp"

namespace adit::dem {
namespace {

using geometry::Point;

constexpr double kNever = std::numeric_limits<double>::infinity();
// Least cosine between the normals of faces that run beside each other; of the two sides of a sharp corner.
constexpr double kBeside = 0.9, kAcross = 0.7;
constexpr double kClosest = 0.48;       // of the size: distance of faces that do not meet
constexpr double kTheSamePoint = 1e-6;  // of the size: where faces meet

// Where the ray from a point along a unit vector meets the piece [m].
double distance_to(const Point& from, const Point& to, const Point& point, const Point& ray, double beside) {
  const double along_x = to.x - from.x, along_y = to.y - from.y;
  const double across = ray.x * along_y - ray.y * along_x, length = std::hypot(along_x, along_y);
  if (std::abs(across) < beside * length) return kNever;
  const double x = from.x - point.x, y = from.y - point.y;
  const double share = (x * ray.y - y * ray.x) / across;
  return share >= 0 && share <= 1 ? (x * along_y - y * along_x) / across : kNever;
}

// Calls visit(distance) for both points in which the ray meets the circle.
template <class Visit>
void visit_crossings(const FaceCircle& circle, const Point& point, const Point& ray, Visit&& visit) {
  const double x = circle.centre.x - point.x, y = circle.centre.y - point.y;
  const double nearest = x * ray.x + y * ray.y, aside = x * ray.y - y * ray.x;
  const double half = std::sqrt(std::max(circle.radius * circle.radius - aside * aside, 0.0));
  if (half < kBeside * circle.radius) return;
  visit(nearest - half);
  visit(nearest + half);
}

// From a point to the nearest one between two others [m].
double distance_between(const Point& from, const Point& to, const Point& point) {
  const double x = to.x - from.x, y = to.y - from.y;
  const double share = ((point.x - from.x) * x + (point.y - from.y) * y) / (x * x + y * y);
  const double nearest = std::clamp(share, 0.0, 1.0);
  return distance_of({from.x + nearest * x, from.y + nearest * y}, point);
}

// Whether the line through a and b has c and d on different sides.
bool separates(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto side = [&](const Point& p) { return (b.x - a.x) * (p.y - a.y) > (b.y - a.y) * (p.x - a.x); };
  return side(c) != side(d);
}

bool meet(const Point& a, const Point& b, const Point& c, const Point& d, double reach) {
  return (separates(a, b, c, d) && separates(c, d, a, b)) || distance_between(a, b, c) < reach ||
         distance_between(a, b, d) < reach || distance_between(c, d, a) < reach ||
         distance_between(c, d, b) < reach;
}

bool meet(const FaceCircle& circle, const Point& from, const Point& to, double reach) {
  return distance_between(from, to, circle.centre) < circle.radius + reach &&
         std::max(distance_of(circle.centre, from), distance_of(circle.centre, to)) > circle.radius - reach;
}

bool meet(const FaceCircle& a, const FaceCircle& b, double reach) {
  const double apart = distance_of(a.centre, b.centre);
  return apart < a.radius + b.radius + reach && apart > std::abs(a.radius - b.radius) - reach;
}

}  // namespace

RoomBeside::RoomBeside(const CellPacking& wanted) : size_(wanted.size) {
  for (std::size_t face = 0; face < wanted.faces.size(); ++face)
    if (const auto* line = std::get_if<FaceLine>(&wanted.faces[face])) {
      const auto& corners = line->corners;
      for (std::size_t k = 0; k + 1 < corners.size(); ++k)
        pieces_.push_back({corners[k], corners[k + 1], face});
      if (line->closed) pieces_.push_back({corners.back(), corners.front(), face});
    } else {
      circles_.push_back({std::get<FaceCircle>(wanted.faces[face]), face});
    }
  const auto corners = geometry::corners(wanted.box);
  for (std::size_t k = 0; k < 4; ++k) sides_.push_back({corners[k], corners[(k + 1) % 4], 0});
}

bool RoomBeside::faces_meet(std::size_t face, std::size_t other) const {
  const double reach = kTheSamePoint * size_;
  for (const auto& a : pieces_)
    for (const auto& b : pieces_)
      if (a.face == face && b.face == other && meet(a.from, a.to, b.from, b.to, reach)) return true;
  for (const auto& a : circles_) {
    if (a.face != face && a.face != other) continue;
    const std::size_t second = a.face == face ? other : face;
    for (const auto& b : pieces_)
      if (b.face == second && meet(a.circle, b.from, b.to, reach)) return true;
    for (const auto& b : circles_)
      if (b.face == second && meet(a.circle, b.circle, reach)) return true;
  }
  return false;
}

void RoomBeside::refuse_close(std::size_t face, std::size_t other) const {
  if (faces_meet(face, other)) return;
  throw std::invalid_argument(
      fmt::format("faces {} and {} of a packing of cells are less than {:.4g} m apart, half the size of a "
                  "cell, but meet nowhere",
                  std::min(face, other), std::max(face, other), size_ / 2));
}

double RoomBeside::at(const Point& point, const Point& normal, std::size_t face) const {
  double room = kNever;
  const auto take = [&](double distance, std::size_t other) {
    if (distance < (other == face ? size_ / 4 : kTheSamePoint * size_)) return;
    if (distance < kClosest * size_ && other != face) refuse_close(face, other);
    room = std::min(room, distance);
  };
  for (const Point& ray : {normal, Point{-normal.x, -normal.y}}) {
    for (const auto& [from, to, other] : pieces_)
      take(distance_to(from, to, point, ray, other == face ? kAcross : kBeside), other);
    for (const auto& [circle, other] : circles_)
      visit_crossings(circle, point, ray, [&, other = other](double distance) { take(distance, other); });
    for (const auto& [from, to, none] : sides_)
      if (const double distance = distance_to(from, to, point, ray, kBeside); distance > 0)
        room = std::min(room, 2 * distance);
  }
  return room;
}

}  // namespace adit::dem

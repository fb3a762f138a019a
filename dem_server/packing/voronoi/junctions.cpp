#include "dem_server/packing/voronoi/junctions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dem_server/packing/voronoi/face_path.hpp"

namespace adit::dem {
namespace {

using geometry::Point;
using geometry::Side;

constexpr double kOvershoot = 1, kUndershoot = 0.25;  // of the size
constexpr double kApart = 1.2;                        // of the size
constexpr double kParallel = 1e-9;                    // sine of an angle

// Points are collected once each.
class Points {
 public:
  explicit Points(double reach) : reach_(reach) {}
  void add(const Point& point) {
    if (std::ranges::none_of(all, [&](const Point& p) { return distance_of(p, point) < reach_; }))
      all.push_back(point);
  }
  void add_if_on(const Side& side, const Point& point) {
    if (distance_between(side, point) < reach_) add(point);
  }
  std::vector<Point> all;

 private:
  double reach_;
};

// Corners that lie on the other side come first: they are the most accurate.
void add_crossings(const Side& a, const Side& b, double reach, Points& points) {
  for (const Point& end : {a.from, a.to}) points.add_if_on(b, end);
  for (const Point& end : {b.from, b.to}) points.add_if_on(a, end);
  const Point u{a.to.x - a.from.x, a.to.y - a.from.y}, v{b.to.x - b.from.x, b.to.y - b.from.y};
  const Point way{b.from.x - a.from.x, b.from.y - a.from.y};
  const double across = u.x * v.y - u.y * v.x;
  if (std::abs(across) < kParallel * std::hypot(u.x, u.y) * std::hypot(v.x, v.y)) return;
  const double share = (way.x * v.y - way.y * v.x) / across;
  const Point crossing{a.from.x + share * u.x, a.from.y + share * u.y};
  if (distance_between(a, crossing) < reach) points.add_if_on(b, crossing);
}

void add_crossings(const FaceCircle& circle, const Side& side, double reach, Points& points) {
  const Point along = unit(side.from, side.to);
  const double x = circle.centre.x - side.from.x, y = circle.centre.y - side.from.y;
  const double nearest = x * along.x + y * along.y, aside = x * along.y - y * along.x;
  if (std::abs(aside) >= circle.radius + reach) return;
  const double half = std::sqrt(std::max(circle.radius * circle.radius - aside * aside, 0.0));
  for (const double place : {nearest - half, nearest + half})
    points.add_if_on(side, {side.from.x + place * along.x, side.from.y + place * along.y});
}

void add_crossings(const FaceCircle& a, const FaceCircle& b, double reach, Points& points) {
  const double apart = distance_of(a.centre, b.centre);
  if (apart >= a.radius + b.radius + reach || apart <= std::abs(a.radius - b.radius) - reach || !(apart > 0))
    return;
  const Point along = unit(a.centre, b.centre);
  const double foot = (apart * apart + a.radius * a.radius - b.radius * b.radius) / (2 * apart);
  const double half = std::sqrt(std::max(a.radius * a.radius - foot * foot, 0.0));
  for (const double aside : {-half, half})
    points.add(
        {a.centre.x + foot * along.x - aside * along.y, a.centre.y + foot * along.y + aside * along.x});
}

double cosine(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y;
}

std::vector<JunctionBranch> branches_of(const CellFace& face, std::size_t number, const Point& point,
                                        double reach) {
  if (const auto* circle = std::get_if<FaceCircle>(&face)) {
    const Point out = unit(circle->centre, point);
    return {{number, true, {-out.y, out.x}}, {number, false, {out.y, -out.x}}};
  }
  std::vector<JunctionBranch> branches;
  for (const Side& side : pieces_of(std::get<FaceLine>(face))) {
    if (distance_between(side, point) >= reach) continue;
    if (distance_of(side.to, point) >= reach) branches.push_back({number, true, unit(point, side.to)});
    if (distance_of(side.from, point) >= reach) branches.push_back({number, false, unit(point, side.from)});
  }
  return branches;
}

bool has_sharp_corner_near(const CellFace& face, const Point& point, double reach, double near) {
  const auto* line = std::get_if<FaceLine>(&face);
  if (line == nullptr) return false;
  const auto corners = opened(*line);
  const auto turns = turns_of(corners, line->closed);
  for (std::size_t k = 0; k < corners.size(); ++k)
    if (const double distance = distance_of(corners[k], point);
        is_sharp(turns[k]) && distance >= reach && distance < near)
      return true;
  return false;
}

class Finding {
 public:
  Finding(const std::vector<CellFace>& faces, const CellSize& size)
      : faces_(faces), size_(size), reach_(kTheSamePoint * size.least()) {}

  void meet(std::size_t a, std::size_t b) {
    for (const Point& point : common_points(faces_[a], faces_[b], reach_)) {
      const auto nearest = std::ranges::min_element(
          junctions, {}, [&](const Junction& j) { return distance_of(j.point, point); });
      const double near = kApart * size_.at(point);
      const double apart = nearest == junctions.end() ? near : distance_of(nearest->point, point);
      if (apart < reach_) {
        join(*nearest, a);
        join(*nearest, b);
      } else if (apart >= near && !has_sharp_corner_near(faces_[a], point, reach_, near) &&
                 !has_sharp_corner_near(faces_[b], point, reach_, near)) {
        Junction junction{point, {}};
        join(junction, a);
        if (join(junction, b)) junctions.push_back(std::move(junction));
      }
    }
  }

  std::vector<Junction> junctions;

 private:
  // Whether a branch of the face joins those that are there.
  bool join(Junction& junction, std::size_t face) const {
    const auto there = [&](const JunctionBranch& branch) { return branch.face == face; };
    if (std::ranges::any_of(junction.branches, there)) return true;
    auto branches = branches_of(faces_[face], face, junction.point, 2 * reach_);
    std::erase_if(branches, [&](const JunctionBranch& branch) {
      return std::ranges::any_of(junction.branches, [&](const JunctionBranch& other) {
        return cosine(branch.direction, other.direction) > std::cos(kLeastAngle);
      });
    });
    junction.branches.insert(junction.branches.end(), branches.begin(), branches.end());
    return !branches.empty();
  }

  const std::vector<CellFace>& faces_;
  const CellSize& size_;
  double reach_;
};

void move_end(Point& end, const Point& before, std::size_t face, const std::vector<CellFace>& faces,
              const CellSize& sizes) {
  const double reach = kTheSamePoint * sizes.least(), size = sizes.at(end);
  const Point out = unit(before, end);
  const double back = std::min(kOvershoot * size, distance_of(before, end) / 2), on = kUndershoot * size;
  const FaceLine about{
      {{end.x - back * out.x, end.y - back * out.y}, {end.x + on * out.x, end.y + on * out.y}}};
  std::vector<Point> points;
  for (std::size_t other = 0; other < faces.size(); ++other) {
    if (other == face) continue;
    for (const Point& point : common_points(about, faces[other], reach))
      if (std::ranges::any_of(branches_of(faces[other], other, point, 2 * reach),
                              [&](const JunctionBranch& branch) {
                                return std::abs(cosine(branch.direction, out)) <= std::cos(kLeastAngle);
                              }))
        points.push_back(point);
  }
  if (!points.empty())
    end = *std::ranges::min_element(points, {}, [&](const Point& p) { return distance_of(p, end); });
}

}  // namespace

bool lies_on(const CellFace& face, const Point& point, double reach) {
  if (const auto* circle = std::get_if<FaceCircle>(&face))
    return std::abs(distance_of(circle->centre, point) - circle->radius) < reach;
  return std::ranges::any_of(pieces_of(std::get<FaceLine>(face)),
                             [&](const Side& piece) { return distance_between(piece, point) < reach; });
}

std::vector<Point> common_points(const CellFace& a, const CellFace& b, double reach) {
  Points points(reach);
  const auto *line_a = std::get_if<FaceLine>(&a), *line_b = std::get_if<FaceLine>(&b);
  if (line_a == nullptr && line_b == nullptr) {
    add_crossings(std::get<FaceCircle>(a), std::get<FaceCircle>(b), reach, points);
  } else if (line_a == nullptr || line_b == nullptr) {
    const auto& circle = std::get<FaceCircle>(line_a == nullptr ? a : b);
    for (const Side& side : pieces_of(line_a == nullptr ? *line_b : *line_a))
      add_crossings(circle, side, reach, points);
  } else {
    for (const Side& side : pieces_of(*line_a))
      for (const Side& other : pieces_of(*line_b)) add_crossings(side, other, reach, points);
  }
  return points.all;
}

std::vector<CellFace> with_ends_on_faces(const std::vector<CellFace>& faces, const CellSize& size) {
  std::vector<CellFace> moved = faces;
  for (std::size_t k = 0; k < faces.size(); ++k)
    if (auto* line = std::get_if<FaceLine>(&moved[k]); line != nullptr && !line->closed) {
      auto& corners = line->corners;
      move_end(corners.front(), corners[1], k, faces, size);
      move_end(corners.back(), corners[corners.size() - 2], k, faces, size);
    }
  return moved;
}

std::vector<Junction> find_junctions(const std::vector<CellFace>& faces, const CellSize& size) {
  Finding finding(faces, size);
  for (std::size_t b = 0; b < faces.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) finding.meet(a, b);
  return std::move(finding.junctions);
}

}  // namespace adit::dem

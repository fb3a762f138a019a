#include "protocol/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace adit::geometry {
namespace {

Point operator-(const Point& a, const Point& b) {
  return {a.x - b.x, a.y - b.y};
}
double dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y;
}
double cross(const Point& a, const Point& b) {
  return a.x * b.y - a.y * b.x;
}

// The vector from the nearest point of the side to `point`.
Point gap(const Side& side, const Point& point) {
  const Point along = side.to - side.from, from = point - side.from;
  const double place = std::clamp(dot(from, along) / dot(along, along), 0.0, 1.0);
  return {from.x - place * along.x, from.y - place * along.y};
}

bool lies_on(const Side& side, const Point& point) {
  const Point to_side = gap(side, point);
  return to_side.x == 0 && to_side.y == 0;
}

// Whether the ends of `b` lie on different sides of the line through `a`.
bool separates(const Side& a, const Side& b) {
  const Point along = a.to - a.from;
  return (cross(along, b.from - a.from) > 0) != (cross(along, b.to - a.from) > 0);
}

bool meet(const Side& a, const Side& b) {
  return (separates(a, b) && separates(b, a)) || lies_on(a, b.from) || lies_on(a, b.to) ||
         lies_on(b, a.from) || lies_on(b, a.to);
}

// Whether the next side turns back along this one.
bool runs_back(const Side& side, const Side& next) {
  const Point a = side.to - side.from, b = next.to - next.from;
  return cross(a, b) == 0 && dot(a, b) < 0;
}

// Whether every side has a length, and meets no other side except the next one in their common end. In a
// closed loop the first side follows the last.
bool meet_in_ends_only(const std::vector<Side>& all, bool closed) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Side &side = all[i], &next = all[(i + 1) % all.size()];
    const bool has_next = closed || i + 1 < all.size();
    if (!(dot(side.to - side.from, side.to - side.from) > 0) || (has_next && runs_back(side, next)))
      return false;
    for (std::size_t j = i + 2; j < all.size(); ++j)
      if (!(closed && i == 0 && j + 1 == all.size()) && meet(side, all[j])) return false;
  }
  return true;
}

// Whether a part of the side lies inside the box and not only on its edge (clipping after Liang and Barsky):
// the share [begin, end] of the side that lies within the box's limits along both axes is not empty.
bool enters(const Side& side, const BoundingBox& box) {
  double begin = 0, end = 1;
  const auto clip = [&](double from, double to, double min, double max) {
    if (from == to) {
      if (from <= min || from >= max) end = begin;
      return;
    }
    const auto [first, last] = std::minmax({(min - from) / (to - from), (max - from) / (to - from)});
    begin = std::max(begin, first);
    end = std::min(end, last);
  };
  clip(side.from.x, side.to.x, box.x_min, box.x_max);
  clip(side.from.y, side.to.y, box.y_min, box.y_max);
  return begin < end;
}

class Polygon : public Shape {
 public:
  explicit Polygon(const std::vector<Loop>& loops) {
    for (const Loop& loop : loops) {
      const auto more = geometry::sides(loop);
      sides_.insert(sides_.end(), more.begin(), more.end());
    }
  }

  double distance(double x, double y) const override { return signed_distance(sides_, {x, y}); }

  // If no side enters the box and no corner of the box lies inside the polygon, then the shortest distance is
  // taken at a corner of the box or at a corner of the polygon.
  double distance(const BoundingBox& box) const override {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Point& c : corners(box)) nearest = std::min(nearest, distance(c.x, c.y));
    for (const Side& side : sides_)
      nearest = std::min(nearest, enters(side, box) ? 0.0 : geometry::distance(side.from, box));
    return std::max(nearest, 0.0);
  }

  bool covers(const BoundingBox& box) const override {
    return std::ranges::all_of(corners(box), [&](const Point& c) { return distance(c.x, c.y) <= 0; }) &&
           std::ranges::none_of(sides_, [&](const Side& side) { return enters(side, box); });
  }

  BoundingBox box_around(double width) const override {
    const auto x = [](const Side& side) { return side.from.x; };
    const auto y = [](const Side& side) { return side.from.y; };
    const auto [left, right] = std::ranges::minmax_element(sides_, {}, x);
    const auto [lower, upper] = std::ranges::minmax_element(sides_, {}, y);
    return {x(*left) - width, x(*right) + width, y(*lower) - width, y(*upper) + width};
  }

 private:
  std::vector<Side> sides_;
};

}  // namespace

std::vector<Side> sides(const Loop& loop) {
  std::vector<Side> result;
  for (std::size_t i = 0; i < loop.size(); ++i) result.push_back({loop[i], loop[(i + 1) % loop.size()]});
  return result;
}

bool is_simple(const Loop& loop) {
  return loop.size() >= 3 && meet_in_ends_only(sides(loop), true);
}

bool is_simple_line(const std::vector<Point>& line) {
  auto all = sides(line);
  all.pop_back();  // the side that would join the last point with the first
  const bool closed = line.front().x == line.back().x && line.front().y == line.back().y;
  return meet_in_ends_only(all, closed);
}

bool meet(const Loop& a, const Loop& b) {
  const auto others = sides(b);
  return std::ranges::any_of(sides(a), [&](const Side& side) {
    return std::ranges::any_of(others, [&](const Side& other) { return meet(side, other); });
  });
}

// The distance to the nearest side. A point lies inside if a ray from it along x crosses an odd number of
// sides.
double signed_distance(const std::vector<Side>& sides, const Point& point) {
  double squared = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (const Side& side : sides) {
    const Point to_side = gap(side, point);
    squared = std::min(squared, dot(to_side, to_side));
    const auto [along_x, along_y] = side.to - side.from;
    const auto [from_x, from_y] = point - side.from;
    if ((side.from.y > point.y) != (side.to.y > point.y) && from_x < from_y * along_x / along_y)
      inside = !inside;
  }
  return inside ? -std::sqrt(squared) : std::sqrt(squared);
}

std::shared_ptr<const Shape> polygon(const std::vector<Loop>& loops) {
  return std::make_shared<Polygon>(loops);
}

}  // namespace adit::geometry

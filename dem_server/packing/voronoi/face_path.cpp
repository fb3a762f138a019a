#include "dem_server/packing/voronoi/face_path.hpp"

#include <algorithm>

namespace adit::dem {
namespace {

using geometry::Point;

constexpr double kBetweenBends = 0.8;  // discs at corners that are not sharp, over the size
constexpr double kStraight = 1e-9;     // [rad]

double turn(const Point& before, const Point& corner, const Point& after) {
  const Point a = unit(before, corner), b = unit(corner, after);
  return std::abs(std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y));
}

}  // namespace

Path path_along(std::vector<Point> corners) {
  std::vector<double> starts{0};
  for (std::size_t k = 1; k < corners.size(); ++k)
    starts.push_back(starts.back() + distance_of(corners[k - 1], corners[k]));
  const double length = starts.back();
  return {length, corners.size() == 2, [corners = std::move(corners), starts = std::move(starts)](double s) {
            const auto after = std::upper_bound(starts.begin() + 1, starts.end() - 1, s) - starts.begin();
            const Point &a = corners[static_cast<std::size_t>(after - 1)],
                        &b = corners[static_cast<std::size_t>(after)];
            const Point along = unit(a, b);
            const double beyond = s - starts[static_cast<std::size_t>(after - 1)];
            return Path::Place{{a.x + beyond * along.x, a.y + beyond * along.y}, {-along.y, along.x}};
          }};
}

Path path_around(const FaceCircle& circle, double start, double length) {
  return {length, false, [circle, start](double s) {
            const double angle = start + s / circle.radius;
            const Point out{std::cos(angle), std::sin(angle)};
            return Path::Place{
                {circle.centre.x + circle.radius * out.x, circle.centre.y + circle.radius * out.y}, out};
          }};
}

std::vector<geometry::Side> pieces_of(const FaceLine& line) {
  auto pieces = geometry::sides(line.corners);
  if (!line.closed) pieces.pop_back();
  return pieces;
}

double distance_between(const geometry::Side& side, const Point& point) {
  const double x = side.to.x - side.from.x, y = side.to.y - side.from.y;
  const double share = ((point.x - side.from.x) * x + (point.y - side.from.y) * y) / (x * x + y * y);
  const double nearest = std::clamp(share, 0.0, 1.0);
  return distance_of({side.from.x + nearest * x, side.from.y + nearest * y}, point);
}

std::vector<Point> opened(const FaceLine& line) {
  std::vector<Point> corners = line.corners;
  if (!line.closed) return corners;
  const std::size_t count = corners.size();
  std::size_t sharpest = 0;
  double most = -1;
  for (std::size_t k = 0; k < count; ++k)
    if (const double t = turn(corners[(k + count - 1) % count], corners[k], corners[(k + 1) % count]);
        t > most) {
      most = t;
      sharpest = k;
    }
  std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(sharpest), corners.end());
  corners.push_back(corners.front());
  return corners;
}

std::vector<double> turns_of(const std::vector<Point>& corners, bool closed) {
  const std::size_t last = corners.size() - 1;
  std::vector<double> turns(corners.size(), 0.0);
  for (std::size_t k = 1; k < last; ++k) turns[k] = turn(corners[k - 1], corners[k], corners[k + 1]);
  if (closed) turns[0] = turns[last] = turn(corners[last - 1], corners[0], corners[1]);
  return turns;
}

std::vector<std::size_t> corners_with_discs(const std::vector<Point>& corners,
                                            const std::vector<double>& turns, const std::vector<bool>& fixed,
                                            const CellSize& size) {
  std::vector<std::size_t> kept{0};
  const std::size_t last = corners.size() - 1;
  double since = 0;
  for (std::size_t k = 1; k < last; ++k) {
    since += distance_of(corners[k - 1], corners[k]);
    const double least = kBetweenBends * size.at(corners[k]);
    double until = 0;
    for (std::size_t j = k; j < last && until < least && (j == k || !fixed[j]); ++j)
      until += distance_of(corners[j], corners[j + 1]);
    const bool far = std::min(since, until) >= least;
    if (!fixed[k] && (!far || turns[k] < kStraight)) continue;
    kept.push_back(k);
    since = 0;
  }
  kept.push_back(last);
  return kept;
}

}  // namespace adit::dem

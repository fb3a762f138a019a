// Ways along faces, and the corners of lines that discs must follow.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <vector>

#include "dem_server/packing/voronoi/cell_points.hpp"
#include "protocol/geometry/polygon.hpp"

namespace adit::dem {

constexpr double kTheSamePoint = 1e-6;  // of the size: where faces meet

inline double distance_of(const geometry::Point& a, const geometry::Point& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

// The unit vector from one point towards another.
inline geometry::Point unit(const geometry::Point& from, const geometry::Point& to) {
  const double length = distance_of(from, to);
  return {(to.x - from.x) / length, (to.y - from.y) / length};
}

// A way along a face, by the distance from its beginning [m].
struct Path {
  struct Place {
    geometry::Point point, normal;
  };
  double length;
  bool straight;
  std::function<Place(double)> at;
};

Path path_along(std::vector<geometry::Point> corners);
Path path_around(const FaceCircle& circle, double start, double length);  // from this angle on

std::vector<geometry::Side> pieces_of(const FaceLine& line);
double distance_between(const geometry::Side& piece, const geometry::Point& point);  // the shortest [m]

// A line from its first corner to its last; of a closed one these are the same, the sharpest of all.
std::vector<geometry::Point> opened(const FaceLine& line);

// How much an opened line turns at each corner, 0 at open ends [rad].
std::vector<double> turns_of(const std::vector<geometry::Point>& corners, bool closed);
inline bool is_sharp(double turn) {
  return turn >= 30 * std::numbers::pi / 180;
}

// Numbers of the corners that get a disc: the ends, those that are `fixed`, and of the others those that turn
// and are far enough from the last one and from the next one of these.
std::vector<std::size_t> corners_with_discs(const std::vector<geometry::Point>& corners,
                                            const std::vector<double>& turns, const std::vector<bool>& fixed,
                                            const CellSize& size);

}  // namespace adit::dem

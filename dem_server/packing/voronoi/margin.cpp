#include "dem_server/packing/voronoi/margin.hpp"

#include <algorithm>

namespace adit::dem {
namespace {

constexpr double kFromSides = 0.25;     // of the size
constexpr double kRounding = 1 - 1e-9;  // a nucleus may lie on the bound

}  // namespace

geometry::BoundingBox Margin::inside() const {
  const double across = std::min(kFromSides * size_.least(), most_x_),
               up = std::min(kFromSides * size_.least(), most_y_);
  return {box_.x_min + across, box_.x_max - across, box_.y_min + up, box_.y_max - up};
}

// Whether the distance from a side, and as much more as `farther`, is less than the width for this size.
bool Margin::is_closer(const geometry::Point& p, double farther, double size) const {
  const double across = std::min(p.x - box_.x_min, box_.x_max - p.x) + farther,
               up = std::min(p.y - box_.y_min, box_.y_max - p.y) + farther;
  return across < kRounding * std::min(kFromSides * size, most_x_) ||
         up < kRounding * std::min(kFromSides * size, most_y_);
}

bool Margin::holds(const geometry::Point& point) const {
  return is_closer(point, 0, size_.at(point));
}

bool Margin::covers(const geometry::Point& middle, double half_diagonal) const {
  return is_closer(middle, half_diagonal, size_.least_around(middle, half_diagonal));
}

}  // namespace adit::dem

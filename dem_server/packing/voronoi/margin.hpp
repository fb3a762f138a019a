// The strip along the sides of a packing's box in which no nucleus lies.
#pragma once

#include "dem_server/packing/voronoi/cell_points.hpp"

namespace adit::dem {

// It is as wide as a quarter of the size, or a quarter of a small box.
class Margin {
 public:
  explicit Margin(const CellPacking& packing)
      : box_(packing.box),
        size_(packing.size),
        most_x_((box_.x_max - box_.x_min) / 4),
        most_y_((box_.y_max - box_.y_min) / 4) {}

  // What of the box remains beside cells of the least size.
  geometry::BoundingBox inside() const;
  bool holds(const geometry::Point& point) const;
  // Whether all of a square lies in the margin, as far as its middle tells.
  bool covers(const geometry::Point& middle, double half_diagonal) const;

 private:
  bool is_closer(const geometry::Point& point, double farther, double size) const;

  geometry::BoundingBox box_;
  CellSize size_;
  double most_x_, most_y_;  // [m]
};

}  // namespace adit::dem

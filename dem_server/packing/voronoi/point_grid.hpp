// Points sorted into square cells while they are being placed.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "protocol/geometry/bounding_box.hpp"
#include "protocol/geometry/shape.hpp"

namespace adit::dem {

class PointGrid {
 public:
  // Takes points of the box, for searches within about `side` [m].
  PointGrid(const geometry::BoundingBox& box, double side)
      : box_(box),
        side_(side),
        columns_(1 + static_cast<std::size_t>((box.x_max - box.x_min) / side)),
        rows_(1 + static_cast<std::size_t>((box.y_max - box.y_min) / side)),
        cells_(columns_ * rows_) {}

  void add(const geometry::Point& point) {
    const auto index = static_cast<std::uint32_t>(points_.size());
    cells_[row(point.y) * columns_ + column(point.x)].push_back(index);
    points_.push_back(point);
  }

  // Whether holds(point) for one of the points within `reach` of the place, or of some farther ones.
  template <class Holds>
  bool any_near(const geometry::Point& place, double reach, Holds&& holds) const {
    for (std::size_t j = row(place.y - reach); j <= row(place.y + reach); ++j)
      for (std::size_t i = column(place.x - reach); i <= column(place.x + reach); ++i)
        for (const std::uint32_t k : cells_[j * columns_ + i])
          if (holds(points_[k])) return true;
    return false;
  }

  bool any_closer(const geometry::Point& place, double reach) const {
    return any_near(place, reach, [&](const geometry::Point& p) {
      return (p.x - place.x) * (p.x - place.x) + (p.y - place.y) * (p.y - place.y) < reach * reach;
    });
  }

  const std::vector<geometry::Point>& points() const { return points_; }

 private:
  std::size_t column(double x) const { return index_of(x - box_.x_min, columns_); }
  std::size_t row(double y) const { return index_of(y - box_.y_min, rows_); }
  std::size_t index_of(double from_edge, std::size_t count) const {
    return static_cast<std::size_t>(std::clamp(from_edge / side_, 0.0, static_cast<double>(count - 1)));
  }

  geometry::BoundingBox box_;
  double side_;
  std::size_t columns_, rows_;
  std::vector<std::vector<std::uint32_t>> cells_;
  std::vector<geometry::Point> points_;
};

}  // namespace adit::dem

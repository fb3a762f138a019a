#include "dem_server/packing/voronoi/fill.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace adit::dem {
namespace {

using geometry::BoundingBox;
using geometry::Point;

constexpr double kLeastDistance = 0.777;  // of the size; cells then have the mean area of hexagonal ones
constexpr double kDarts = 0.6;            // thrown for each square before the squares are divided
constexpr int kDivisions = 24;            // what is smaller is not seen as room

class Filling {
 public:
  // At first a square is so small that one point in it leaves no room for another, where cells are largest.
  Filling(const Margin& margin, const CellSize& size, std::span<const DiscField> discs,
          motion::Random& random, PointGrid& points)
      : margin_(margin),
        inside_(margin.inside()),
        size_(size),
        discs_(discs),
        random_(random),
        points_(points) {
    const auto count = [&size](double length) {
      return static_cast<std::uint64_t>(
          std::max(1.0, std::ceil(length * std::numbers::sqrt2 / (kLeastDistance * size.largest()))));
    };
    const std::uint64_t columns = count(inside_.x_max - inside_.x_min),
                        rows = count(inside_.y_max - inside_.y_min);
    width_ = (inside_.x_max - inside_.x_min) / static_cast<double>(columns);
    height_ = (inside_.y_max - inside_.y_min) / static_cast<double>(rows);
    for (std::uint64_t j = 0; j < rows; ++j)
      for (std::uint64_t i = 0; i < columns; ++i) keep_if_open({i, j}, open_);
  }

  bool has_room() const { return !open_.empty(); }

  void throw_darts() {
    const auto darts = static_cast<std::size_t>(std::ceil(kDarts * static_cast<double>(open_.size())));
    for (std::size_t k = 0; k < darts && has_room(); ++k) {
      const auto hit = static_cast<std::size_t>(random_.uniform() * static_cast<double>(open_.size()));
      const double share_x = random_.uniform(), share_y = random_.uniform();
      const Point dart{inside_.x_min + (static_cast<double>(open_[hit].i) + share_x) * width_,
                       inside_.y_min + (static_cast<double>(open_[hit].j) + share_y) * height_};
      if (!is_free(dart)) continue;
      points_.add(dart);
      const Point middle = middle_of(open_[hit]);
      if (!leaves_no_room(dart, middle, least_around(middle))) continue;
      open_[hit] = open_.back();
      open_.pop_back();
    }
  }

  void divide() {
    width_ /= 2;
    height_ /= 2;
    std::vector<Square> quarters;
    for (const auto& [i, j] : open_)
      for (const std::uint64_t up : {0u, 1u})
        for (const std::uint64_t across : {0u, 1u}) keep_if_open({2 * i + across, 2 * j + up}, quarters);
    open_ = std::move(quarters);
  }

 private:
  struct Square {
    std::uint64_t i, j;  // column and row
  };

  bool is_free(const Point& p) const {
    return !points_.any_closer(p, kLeastDistance * size_.at(p)) && !margin_.holds(p) &&
           std::ranges::none_of(discs_, [&](const DiscField& field) { return field.hold(p); });
  }

  Point middle_of(const Square& square) const {
    return {inside_.x_min + static_cast<double>(square.i) * width_ + width_ / 2,
            inside_.y_min + static_cast<double>(square.j) * height_ + height_ / 2};
  }
  double half_diagonal() const { return std::hypot(width_, height_) / 2; }
  // The distance that points of a square have at least from others.
  double least_around(const Point& middle) const {
    return kLeastDistance * size_.least_around(middle, half_diagonal());
  }
  // Whether the surroundings of a point hold all of the square.
  bool leaves_no_room(const Point& p, const Point& middle, double least) const {
    return std::hypot(std::abs(p.x - middle.x) + width_ / 2, std::abs(p.y - middle.y) + height_ / 2) < least;
  }

  // A square is closed if one disc, the surroundings of one point or the margin hold it.
  void keep_if_open(const Square& square, std::vector<Square>& squares) const {
    const Point middle = middle_of(square);
    const double least = least_around(middle);
    if (points_.any_near(middle, least, [&](const Point& p) { return leaves_no_room(p, middle, least); }) ||
        margin_.covers(middle, half_diagonal()))
      return;
    const double x = inside_.x_min + static_cast<double>(square.i) * width_;
    const double y = inside_.y_min + static_cast<double>(square.j) * height_;
    const BoundingBox box{x, x + width_, y, y + height_};
    if (std::ranges::none_of(discs_, [&](const DiscField& field) { return field.cover(box); }))
      squares.push_back(square);
  }

  const Margin& margin_;
  BoundingBox inside_;
  const CellSize& size_;
  std::span<const DiscField> discs_;
  motion::Random& random_;
  PointGrid& points_;
  double width_, height_;  // of a square [m]
  std::vector<Square> open_;
};

}  // namespace

void fill(const Margin& margin, const CellSize& size, std::span<const DiscField> discs,
          motion::Random& random, PointGrid& points) {
  Filling filling(margin, size, discs, random, points);
  for (int division = 0; division < kDivisions && filling.has_room(); ++division) {
    filling.throw_darts();
    filling.divide();
  }
}

}  // namespace adit::dem

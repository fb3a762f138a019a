#include "dem_server/packing/voronoi/fill.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace adit::dem {
namespace {

using geometry::BoundingBox;
using geometry::Point;

constexpr double kDarts = 0.6;  // thrown for each square before the squares are divided
constexpr int kDivisions = 24;  // what is smaller is not seen as room

class Filling {
 public:
  // A square is so small that one point in it leaves no room for another.
  Filling(const BoundingBox& inside, double least, std::span<const DiscField> discs, motion::Random& random,
          PointGrid& points)
      : inside_(inside), least_(least), discs_(discs), random_(random), points_(points) {
    const auto count = [least](double length) {
      return static_cast<std::uint64_t>(std::max(1.0, std::ceil(length * std::numbers::sqrt2 / least)));
    };
    const std::uint64_t columns = count(inside.x_max - inside.x_min),
                        rows = count(inside.y_max - inside.y_min);
    width_ = (inside.x_max - inside.x_min) / static_cast<double>(columns);
    height_ = (inside.y_max - inside.y_min) / static_cast<double>(rows);
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
    return !points_.any_closer(p, least_) &&
           std::ranges::none_of(discs_, [&](const DiscField& field) { return field.hold(p); });
  }

  // A square is closed if one disc or the surroundings of one point hold it.
  void keep_if_open(const Square& square, std::vector<Square>& squares) const {
    const double x = inside_.x_min + static_cast<double>(square.i) * width_;
    const double y = inside_.y_min + static_cast<double>(square.j) * height_;
    const Point middle{x + width_ / 2, y + height_ / 2};
    const bool near_point = points_.any_near(middle, least_, [&](const Point& p) {
      return std::hypot(std::abs(p.x - middle.x) + width_ / 2, std::abs(p.y - middle.y) + height_ / 2) <
             least_;
    });
    const BoundingBox box{x, x + width_, y, y + height_};
    if (!near_point && std::ranges::none_of(discs_, [&](const DiscField& field) { return field.cover(box); }))
      squares.push_back(square);
  }

  BoundingBox inside_;
  double least_;
  std::span<const DiscField> discs_;
  motion::Random& random_;
  PointGrid& points_;
  double width_, height_;  // of a square [m]
  std::vector<Square> open_;
};

}  // namespace

void fill(const BoundingBox& inside, double least, std::span<const DiscField> discs, motion::Random& random,
          PointGrid& points) {
  Filling filling(inside, least, discs, random, points);
  for (int division = 0; division < kDivisions && filling.has_room(); ++division) {
    filling.throw_darts();
    filling.divide();
  }
}

}  // namespace adit::dem

#include "fdm_server/meshing/mapped_block.hpp"

#include <cmath>

namespace adit::fdm {
namespace {

Point lerp(const Point& a, const Point& b, double s) {
  return {std::lerp(a.x, b.x, s), std::lerp(a.y, b.y, s)};
}

}  // namespace

std::vector<double> places(const Division& division) {
  const std::uint32_t n = division.zones;
  std::vector<double> result{0};
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t power = division.from_both_ends ? std::min(i, n - 1 - i) : i;
    result.push_back(result.back() + std::pow(division.ratio, power));
  }
  const double whole = result.back();
  // The last place is divided by itself and is exactly 1.
  for (double& place : result) place /= whole;
  return result;
}

Point Side::at(double s) const {
  if (s == 0) return from_;
  if (s == 1) return to_;
  if (!arc_) return lerp(from_, to_, s);
  const double cosine = std::cos(s * arc_->sweep), sine = std::sin(s * arc_->sweep);
  const double x = from_.x - arc_->centre.x, y = from_.y - arc_->centre.y;
  return {arc_->centre.x + cosine * x - sine * y, arc_->centre.y + sine * x + cosine * y};
}

std::vector<Point> points(const MappedBlock& block) {
  const auto& [lower, right, upper, left] = block.sides;
  const auto along = places(block.along), across = places(block.across);
  std::vector<Point> result;
  result.reserve(along.size() * across.size());
  for (const double v : across)
    for (const double u : along) {
      const Point between_u = lerp(lower.at(u), upper.at(u), v), between_v = lerp(left.at(v), right.at(v), u);
      const Point bilinear = lerp(lerp(lower.at(0), lower.at(1), u), lerp(upper.at(0), upper.at(1), u), v);
      // In this order the bracket is exactly 0 on the lower and the upper side, so that points there lie on
      // the side to the bit.
      result.push_back({between_u.x + (between_v.x - bilinear.x), between_u.y + (between_v.y - bilinear.y)});
    }
  return result;
}

}  // namespace adit::fdm

#include "protocol/geometry/selection.hpp"

#include <algorithm>
#include <limits>

#include "protocol/errors.hpp"
#include "protocol/geometry/read_shape.hpp"

namespace adit::protocol {

Places::Places(const scene::Area& area, const std::string& path, double tolerance)
    : area_(area), tolerance_(tolerance) {
  if (area.has_circle()) shapes_.push_back(geometry::read_circle(area.circle()));
  if (area.has_annulus()) shapes_.push_back(geometry::read_annulus(area.annulus()));
  if (area.has_band()) shapes_.push_back(geometry::read_band(area.band(), path + ".band"));
  if (area.has_polygon()) shapes_.push_back(geometry::read_polygon(area.polygon(), path + ".polygon"));
}

bool Places::hold(double x, double y) const {
  return (!area_.has_x_min() || x >= area_.x_min() - tolerance_) &&
         (!area_.has_x_max() || x <= area_.x_max() + tolerance_) &&
         (!area_.has_y_min() || y >= area_.y_min() - tolerance_) &&
         (!area_.has_y_max() || y <= area_.y_max() + tolerance_) &&
         std::ranges::all_of(shapes_, [&](const auto& shape) { return shape->distance(x, y) <= tolerance_; });
}

double Places::distance(double x, double y) const {
  double farthest = -std::numeric_limits<double>::infinity();
  const auto take = [&](bool has, double distance) {
    if (has) farthest = std::max(farthest, distance);
  };
  take(area_.has_x_min(), area_.x_min() - x);
  take(area_.has_x_max(), x - area_.x_max());
  take(area_.has_y_min(), area_.y_min() - y);
  take(area_.has_y_max(), y - area_.y_max());
  for (const auto& shape : shapes_) take(true, shape->distance(x, y));
  return farthest;
}

std::vector<std::uint32_t> select(const scene::Area& area, std::span<const double> points, double tolerance,
                                  const std::string& path, const std::string& what) {
  if (area.has_group())
    throw UserError(path + ".group", "is given, but " + what + " have no groups; select them by place");
  const Places places(area, path, tolerance);
  std::vector<std::uint32_t> chosen;
  for (std::size_t i = 0; 2 * i < points.size(); ++i)
    if (places.hold(points[2 * i], points[2 * i + 1])) chosen.push_back(static_cast<std::uint32_t>(i));
  if (chosen.empty()) refuse_empty(path, what);
  return chosen;
}

void refuse_empty(const std::string& path, const std::string& what) {
  throw UserError(path, "selects no " + what + "; widen it so that it holds at least one");
}

}  // namespace adit::protocol

#include "protocol/geometry/read_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "protocol/errors.hpp"
#include "protocol/geometry/polygon.hpp"

namespace adit::geometry {

using protocol::require;

void require_arc(const scene::RoundPath& circle, const std::string& path) {
  require(circle.has_from() == circle.has_to(), path,
          "names one end of an arc; give `from` and `to`, or neither for a whole circle");
  require(!circle.has_from() ||
              (circle.to() > circle.from() && circle.to() - circle.from() <= 2 * std::numbers::pi),
          path + ".to",
          fmt::format("is {} rad, but must be larger than `from` = {} rad, by at most a full turn",
                      circle.to(), circle.from()));
}

void require_simple(const std::vector<Point>& points, const std::string& path) {
  const auto elsewhere = [&](const Point& point) {
    return point.x != points.front().x || point.y != points.front().y;
  };
  require(std::ranges::any_of(points, elsewhere) && is_simple_line(points), path + ".points",
          "cross, touch or run back over one another; give a line that passes every place once");
}

}  // namespace adit::geometry

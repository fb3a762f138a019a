#include "protocol/selection.hpp"

#include "protocol/errors.hpp"

namespace adit::protocol {

bool inside(const scene::Box& box, double x, double y, double tolerance) {
  return (!box.has_x_min() || x >= box.x_min() - tolerance) &&
         (!box.has_x_max() || x <= box.x_max() + tolerance) &&
         (!box.has_y_min() || y >= box.y_min() - tolerance) &&
         (!box.has_y_max() || y <= box.y_max() + tolerance);
}

std::vector<std::uint32_t> select(const scene::Box& box, std::span<const double> points, double tolerance,
                                  const std::string& path, const std::string& what) {
  std::vector<std::uint32_t> chosen;
  for (std::size_t i = 0; 2 * i < points.size(); ++i)
    if (inside(box, points[2 * i], points[2 * i + 1], tolerance))
      chosen.push_back(static_cast<std::uint32_t>(i));
  if (chosen.empty())
    throw UserError(path, "selects no " + what + "; widen the box so that it holds at least one");
  return chosen;
}

}  // namespace adit::protocol

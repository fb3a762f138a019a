#include "dem_server/packing/square.hpp"

#include <cmath>

namespace adit::dem {

Discs pack_squarely(const geometry::BoundingBox& box, double radius) {
  // forgiving the rounding of lengths such as 20 * 0.05
  const auto whole = [radius](double length) { return std::floor(length / (2 * radius) + 1e-6); };
  const double columns = whole(box.x_max - box.x_min), rows = whole(box.y_max - box.y_min);
  const double x = 0.5 * (box.x_min + box.x_max) - (columns - 1) * radius;
  const double y = 0.5 * (box.y_min + box.y_max) - (rows - 1) * radius;
  Discs discs;
  for (double j = 0; j < rows; ++j)
    for (double i = 0; i < columns; ++i) {
      discs.x.push_back(x + 2 * i * radius);
      discs.y.push_back(y + 2 * j * radius);
      discs.radius.push_back(radius);
    }
  return discs;
}

}  // namespace adit::dem

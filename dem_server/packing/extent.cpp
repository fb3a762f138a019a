#include "dem_server/packing/extent.hpp"

#include <algorithm>

namespace adit::dem {

geometry::BoundingBox extent_of(const Discs& d) {
  geometry::BoundingBox box{d.x[0], d.x[0], d.y[0], d.y[0]};
  for (std::size_t i = 0; i < d.size(); ++i) {
    box.x_min = std::min(box.x_min, d.x[i] - d.radius[i]);
    box.x_max = std::max(box.x_max, d.x[i] + d.radius[i]);
    box.y_min = std::min(box.y_min, d.y[i] - d.radius[i]);
    box.y_max = std::max(box.y_max, d.y[i] + d.radius[i]);
  }
  return box;
}

}  // namespace adit::dem

// A box along the axes: the extent of a model, or of the places where an overlap may lie.
#pragma once

namespace adit::geometry {

struct BoundingBox {
  double x_min, x_max, y_min, y_max;  // [m]
};

}  // namespace adit::geometry

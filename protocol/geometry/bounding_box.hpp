// A box along the axes: where a model reaches, where an overlap may lie.
#pragma once

namespace adit::geometry {

struct BoundingBox {
  double x_min, x_max, y_min, y_max;  // [m]
};

}  // namespace adit::geometry

#include "fdm_server/zones/nonlinear/sampling_shape.hpp"

#include <cmath>
#include <cstddef>

#include "fdm_server/zones/shape/assumed_strain.hpp"
#include "fdm_server/zones/shape/hourglass.hpp"
#include "fdm_server/zones/shape/mean_gradient.hpp"
#include "fdm_server/zones/shape/mixed_discretization.hpp"

namespace adit::fdm {
namespace {

// From coefficients of d/dx and d/dy.
SamplingPoint sampling_point(double area, const CornerValues& x, const CornerValues& y) {
  SamplingPoint point{area, x, y, y, x};
  for (double& value : point.difference_y) value = -value;
  return point;
}

void sample_triangles(const Corners& corners, SamplingShape& shape) {
  const auto [gradients, areas] = triangles(corners);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto [a, b, c] = kTriangles[k];
    const auto& g = gradients[k];
    CornerValues x{}, y{};
    x[a] = -g.x1 - g.x2;
    x[b] = g.x1;
    x[c] = g.x2;
    y[a] = -g.y1 - g.y2;
    y[b] = g.y1;
    y[c] = g.y2;
    shape.points[k] = sampling_point(areas[k] / 2, x, y);
  }
}

void sample_bending(const Corners& corners, const PlaneLaw& law, SamplingShape& shape) {
  const auto pattern = gamma(corners, mean_gradient(corners));
  const auto points = gauss_points(corners);
  const double twice = 2 * std::sqrt(law.bulk / (law.bulk + law.shear));
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& [area, hx, hy] = points[k];
    shape.points[k] = sampling_point(area, shape.x, shape.y);
    for (std::size_t c = 0; c < 4; ++c) {
      shape.points[k].difference_x[c] += twice * hx * pattern[c];
      shape.points[k].difference_y[c] -= twice * hy * pattern[c];
    }
  }
}

}  // namespace

SamplingShape sampling_shape(ZoneKind kind, const Corners& corners, const PlaneLaw& law) {
  const auto g = mean_gradient(corners);
  SamplingShape shape{area(corners), {g.x0, g.x1, -g.x0, -g.x1}, {g.y0, g.y1, -g.y0, -g.y1}, {}};
  if (kind == ZoneKind::kMixedDiscretization)
    sample_triangles(corners, shape);
  else
    sample_bending(corners, law, shape);
  return shape;
}

}  // namespace adit::fdm

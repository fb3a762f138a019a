#include "fdm_server/zones/shape/mixed_discretization.hpp"

namespace adit::fdm {

Triangles triangles(const Corners& c) {
  Triangles result{};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto [i, j, l] = kTriangles[k];
    const double x1 = c.x[j] - c.x[i], y1 = c.y[j] - c.y[i], x2 = c.x[l] - c.x[i], y2 = c.y[l] - c.y[i];
    const double twice = x1 * y2 - x2 * y1;
    result.areas[k] = twice / 2;
    result.gradients[k] = {y2 / twice, -y1 / twice, -x2 / twice, x1 / twice};
  }
  return result;
}

std::array<std::array<double, 2>, 4> pattern_gradients(const Triangles& triangles) {
  std::array<std::array<double, 2>, 4> gradients{};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto [i, j, l] = kTriangles[k];
    const double h1 = kHourglass[j] - kHourglass[i], h2 = kHourglass[l] - kHourglass[i];
    const auto& [x1, x2, y1, y2] = triangles.gradients[k];
    gradients[k] = {x1 * h1 + x2 * h2, y1 * h1 + y2 * h2};
  }
  return gradients;
}

HourglassStiffness mixed_discretization_stiffness(const Corners& corners, const PlaneLaw& law) {
  const Triangles of_zone = triangles(corners);
  const auto gradients = pattern_gradients(of_zone);
  double stiffness = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto [gx, gy] = gradients[k];
    stiffness += law.shear * of_zone.areas[k] / 2 * (gx * gx + gy * gy);
  }
  return {stiffness, stiffness, 0};
}

}  // namespace adit::fdm

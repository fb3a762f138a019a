#include "fdm_server/zones/hourglass.hpp"

#include <cmath>
#include <cstddef>

#include "fdm_server/zones/mean_gradient.hpp"

namespace adit::fdm {

HourglassShape hourglass_shape(const Corners& c) {
  constexpr std::array<double, 4> kXi{-1, 1, 1, -1}, kEta{-1, -1, 1, 1};
  const auto g = mean_gradient(c);
  const std::array<double, 4> bx{g.x0, g.x1, -g.x0, -g.x1}, by{g.y0, g.y1, -g.y0, -g.y1};
  double h_x = 0, h_y = 0;
  for (std::size_t a = 0; a < 4; ++a) {
    h_x += kXi[a] * kEta[a] * c.x[a];
    h_y += kXi[a] * kEta[a] * c.y[a];
  }
  HourglassShape shape{};
  for (std::size_t a = 0; a < 4; ++a) shape.gamma[a] = 0.25 * (kXi[a] * kEta[a] - h_x * bx[a] - h_y * by[a]);

  const double gauss = 1 / std::sqrt(3.0);
  for (std::size_t point = 0; point < 4; ++point) {
    const double xi = gauss * kXi[point], eta = gauss * kEta[point];
    double x_xi = 0, x_eta = 0, y_xi = 0, y_eta = 0;
    for (std::size_t a = 0; a < 4; ++a) {
      const double n_xi = 0.25 * kXi[a] * (1 + kEta[a] * eta), n_eta = 0.25 * kEta[a] * (1 + kXi[a] * xi);
      x_xi += n_xi * c.x[a];
      x_eta += n_eta * c.x[a];
      y_xi += n_xi * c.y[a];
      y_eta += n_eta * c.y[a];
    }
    const double jacobian = x_xi * y_eta - x_eta * y_xi;
    shape.points[point] = {jacobian, (eta * y_eta - xi * y_xi) / jacobian, (xi * x_xi - eta * x_eta) / jacobian};
  }
  return shape;
}

}  // namespace adit::fdm

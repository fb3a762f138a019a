#include "fdm_server/zones/shape/assumed_strain.hpp"

#include <array>
#include <cmath>

namespace adit::fdm {
namespace {

// At xi = +-at, eta = +-at.
std::array<GaussPoint, 4> points_at(const Corners& c, double at) {
  constexpr std::array<double, 4> kXi{-1, 1, 1, -1}, kEta{-1, -1, 1, 1};
  std::array<GaussPoint, 4> points{};
  for (std::size_t point = 0; point < 4; ++point) {
    const double xi = at * kXi[point], eta = at * kEta[point];
    double x_xi = 0, x_eta = 0, y_xi = 0, y_eta = 0;
    for (std::size_t a = 0; a < 4; ++a) {
      const double n_xi = 0.25 * kXi[a] * (1 + kEta[a] * eta), n_eta = 0.25 * kEta[a] * (1 + kXi[a] * xi);
      x_xi += n_xi * c.x[a];
      x_eta += n_eta * c.x[a];
      y_xi += n_xi * c.y[a];
      y_eta += n_eta * c.y[a];
    }
    const double jacobian = x_xi * y_eta - x_eta * y_xi;
    points[point] = {jacobian, (eta * y_eta - xi * y_xi) / jacobian, (xi * x_xi - eta * x_eta) / jacobian};
  }
  return points;
}

}  // namespace

std::array<GaussPoint, 4> gauss_points(const Corners& corners) {
  return points_at(corners, 1 / std::sqrt(3.0));
}

std::array<GaussPoint, 4> corner_points(const Corners& corners) {
  return points_at(corners, 1);
}

HourglassStiffness assumed_strain_stiffness(const Corners& corners, const PlaneLaw& law) {
  double hxx = 0, hyy = 0, hxy = 0;
  for (const auto& [area, hx, hy] : gauss_points(corners)) {
    hxx += hx * hx * area;
    hyy += hy * hy * area;
    hxy += hx * hy * area;
  }
  const double young = law.young_prime();
  return {young * hxx, young * hyy, -young * law.poisson_prime() * hxy};
}

}  // namespace adit::fdm
